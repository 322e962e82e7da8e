// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/contact_ghosts.h"

#include "ricochet/base/exchange.h"
#include "ricochet/base/mpi_tags.h"

#include <algorithm>
#include <numeric>

namespace ricochet
{
ContactGhosts::ContactGhosts(const MPI_Comm communicator, const Bodies &bodies,
                             const ContactNumbering &numbering) :
  communicator_(communicator),
  bodies_(bodies), numbering_(numbering)
{
  MPI_Comm_rank(communicator, &rank_);
  MPI_Comm_size(communicator, &n_ranks_);
}

void ContactGhosts::clear()
{
  points_.clear();
  numbers_.clear();
}

std::int32_t ContactGhosts::number_of(const ContactPoint &point)
{
  const auto [entry, is_new] =
      numbers_.emplace(point.id, static_cast<std::int32_t>(points_.size()));
  if (is_new)
    points_.push_back(point);
  return entry->second;
}

std::vector<std::int32_t> ContactGhosts::sort()
{
  std::vector<std::int32_t> order(points_.size()), new_number(points_.size());
  std::iota(order.begin(), order.end(), 0);
  std::sort(order.begin(), order.end(),
            [&](const std::int32_t i, const std::int32_t j)
            { return points_[i].id < points_[j].id; });
  std::vector<ContactPoint> sorted;
  sorted.reserve(points_.size());
  for (const std::int32_t i : order)
  {
    new_number[i]           = static_cast<std::int32_t>(sorted.size());
    numbers_[points_[i].id] = new_number[i];
    sorted.push_back(points_[i]);
  }
  points_ = std::move(sorted);
  return new_number;
}

void ContactGhosts::watch()
{
  std::vector<std::vector<Follower>> asked(n_ranks_);
  watched_of_.assign(n_ranks_, {});
  followers_.clear();
  for (std::size_t i = 0; i < points_.size(); ++i)
  {
    const ContactPoint &point = points_[i];
    Follower follower{point.flat, static_cast<std::int16_t>(numbering_.place(point.id).body),
                      point.image};
    if (point.rank != rank_)
    {
      asked[point.rank].push_back(follower);
      watched_of_[point.rank].push_back(static_cast<std::int32_t>(i));
      follower.flat = -1;
    }
    followers_.push_back(follower);
  }
  watched_by_ = exchange_lists(communicator_, asked);
  watched_.resize(points_.size());
}

ContactGhosts::Watched ContactGhosts::look_at(const Follower &follower) const
{
  const auto &body = *bodies_[follower.body];
  const auto &a    = body.state().arrays;
  const auto p     = follower.flat;
  const double y   = follower.image ? -1. : 1.;
  return {{a.position[0][p], y * a.position[1][p], a.position[2][p]},
          body.is_damaged(p) ? 1. : 0.,
          {a.velocity[0][p], y * a.velocity[1][p], a.velocity[2][p]}};
}

void ContactGhosts::update()
{
  for (std::size_t i = 0; i < followers_.size(); ++i)
    if (followers_[i].flat >= 0)
      watched_[i] = look_at(followers_[i]);

  constexpr int numbers = sizeof(Watched) / sizeof(double);
  std::vector<MPI_Request> requests;
  std::vector<std::vector<Watched>> in(n_ranks_), out(n_ranks_);
  for (int r = 0; r < n_ranks_; ++r)
    if (!watched_of_[r].empty())
    {
      in[r].resize(watched_of_[r].size());
      MPI_Irecv(in[r][0].position, numbers * static_cast<int>(in[r].size()), MPI_DOUBLE, r,
                mpi_tag::contact_ghosts, communicator_, &requests.emplace_back());
    }
  for (int r = 0; r < n_ranks_; ++r)
    if (!watched_by_[r].empty())
    {
      for (const auto &follower : watched_by_[r])
        out[r].push_back(look_at(follower));
      MPI_Isend(out[r][0].position, numbers * static_cast<int>(out[r].size()), MPI_DOUBLE, r,
                mpi_tag::contact_ghosts, communicator_, &requests.emplace_back());
    }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (int r = 0; r < n_ranks_; ++r)
    for (std::size_t i = 0; i < in[r].size(); ++i)
      watched_[watched_of_[r][i]] = in[r][i];
}
} // namespace ricochet
