// SPDX-License-Identifier: LGPL-2.1-or-later
#include "contact_ghosts.h"

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

void ContactGhosts::set_up_exchange()
{
  std::vector<std::vector<Source>> asked(n_ranks_);
  received_.assign(n_ranks_, {});
  sources_.clear();
  for (std::size_t i = 0; i < points_.size(); ++i)
  {
    const ContactPoint &point = points_[i];
    Source source{point.flat, static_cast<std::int16_t>(numbering_.place(point.id).body),
                  point.image};
    if (point.rank != rank_)
    {
      asked[point.rank].push_back(source);
      received_[point.rank].push_back(static_cast<std::int32_t>(i));
      source.flat = -1;
    }
    sources_.push_back(source);
  }
  sent_ = exchange_lists(communicator_, asked);
  ghosts_.resize(points_.size());
}

ContactGhosts::Ghost ContactGhosts::ghost_of(const Source &source) const
{
  const auto &body = *bodies_[source.body];
  const auto &a    = body.state().arrays;
  const auto p     = source.flat;
  const double y   = source.image ? -1. : 1.;
  return {{a.position[0][p], y * a.position[1][p], a.position[2][p]},
          body.is_open(p) ? 1. : 0.,
          {a.velocity[0][p], y * a.velocity[1][p], a.velocity[2][p]}};
}

void ContactGhosts::update()
{
  for (std::size_t i = 0; i < sources_.size(); ++i)
    if (sources_[i].flat >= 0)
      ghosts_[i] = ghost_of(sources_[i]);

  constexpr int numbers = sizeof(Ghost) / sizeof(double);
  std::vector<MPI_Request> requests;
  std::vector<std::vector<Ghost>> in(n_ranks_), out(n_ranks_);
  for (int r = 0; r < n_ranks_; ++r)
    if (!received_[r].empty())
    {
      in[r].resize(received_[r].size());
      MPI_Irecv(in[r][0].position, numbers * static_cast<int>(in[r].size()), MPI_DOUBLE, r,
                mpi_tag::contact_ghosts, communicator_, &requests.emplace_back());
    }
  for (int r = 0; r < n_ranks_; ++r)
    if (!sent_[r].empty())
    {
      for (const auto &source : sent_[r])
        out[r].push_back(ghost_of(source));
      MPI_Isend(out[r][0].position, numbers * static_cast<int>(out[r].size()), MPI_DOUBLE, r,
                mpi_tag::contact_ghosts, communicator_, &requests.emplace_back());
    }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  for (int r = 0; r < n_ranks_; ++r)
    for (std::size_t i = 0; i < in[r].size(); ++i)
      ghosts_[received_[r][i]] = in[r][i];
}
} // namespace ricochet
