// SPDX-License-Identifier: LGPL-2.1-or-later
#include "shared_sums.h"

#include "ricochet/base/exchange.h"
#include "ricochet/base/mpi_tools.h"

#include <algorithm>
#include <tuple>

namespace ricochet
{
namespace
{
void add_triple(const double *const from, double *const to)
{
  for (int d = 0; d < 3; ++d)
    to[d] += from[d];
}
} // namespace

TripleMessages::TripleMessages(const MPI_Comm communicator, const int tag,
                               const std::vector<int> &n_sent) :
  communicator_(communicator),
  tag_(tag)
{
  std::vector<int> n_received(n_sent.size());
  MPI_Alltoall(n_sent.data(), 1, MPI_INT, n_received.data(), 1, MPI_INT, communicator);
  std::size_t n = 0;
  for (int r = 0; r < static_cast<int>(n_sent.size()); ++r)
  {
    if (n_sent[r] > 0)
      to_.push_back({r, 3 * n_sent[r]});
    if (n_received[r] > 0)
      from_.push_back({r, 3 * n_received[r]});
    n += 3 * static_cast<std::size_t>(n_received[r]);
  }
  received_.resize(n);
}

const std::vector<double> &TripleMessages::exchange(const double *sent)
{
  std::vector<MPI_Request> requests;
  double *next = received_.data();
  for (const auto &peer : from_)
  {
    MPI_Irecv(next, peer.n, MPI_DOUBLE, peer.rank, tag_, communicator_, &requests.emplace_back());
    next += peer.n;
  }
  for (const auto &peer : to_)
  {
    MPI_Isend(sent, peer.n, MPI_DOUBLE, peer.rank, tag_, communicator_, &requests.emplace_back());
    sent += peer.n;
  }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);
  return received_;
}

NodeCopies::NodeCopies(const MPI_Comm communicator, std::vector<Corner> corners,
                       const std::int64_t first_owned_node, const int n_local) :
  corners_(std::move(corners)),
  first_copy_(n_local)
{
  // What goes to a rank lies in a row; what this rank owns itself comes last.
  const int rank = rank_in(communicator), n_ranks = size_of(communicator);
  const auto key = [&](const Corner &c)
  { return std::make_tuple(c.rank == rank ? n_ranks : c.rank, c.node, c.order); };
  std::sort(corners_.begin(), corners_.end(),
            [&](const Corner &a, const Corner &b) { return key(a) < key(b); });

  struct Sent
  {
    std::int64_t node, order;
  };
  std::vector<std::vector<Sent>> sent(n_ranks);
  std::vector<int> n_sent(n_ranks, 0);
  const int n_copies = static_cast<int>(corners_.size());
  for (int i = 0; i < n_copies; ++i)
    if (const auto &corner = corners_[i]; corner.rank == rank)
      terms_.push_back({corner.local, 0, corner.order, n_local + i});
    else
    {
      sent[corner.rank].push_back({corner.node, corner.order});
      ++n_sent[corner.rank];
    }
  int source = n_local + n_copies;
  for (const auto &one : joined(exchange_lists(communicator, sent)))
    terms_.push_back({static_cast<int>(one.node - first_owned_node), 0, one.order, source++});
  messages_ = TripleMessages(communicator, mpi_tag::element_sums, n_sent);
}

void NodeCopies::take_values(double *const values) const
{
  for (std::size_t i = 0; i < corners_.size(); ++i)
    std::copy_n(values + 3 * static_cast<std::ptrdiff_t>(corners_[i].local), 3,
                values + 3 * (first_copy_ + static_cast<std::ptrdiff_t>(i)));
}

void NodeCopies::add_up(double *const values, const HexMesh::SummationOrder &order)
{
  const std::ptrdiff_t end = first_copy_ + static_cast<std::ptrdiff_t>(corners_.size());
  const auto &received     = messages_.exchange(values + 3 * std::ptrdiff_t(first_copy_));
  for (const auto &term : order.terms)
    add_triple(term.source < end ? values + 3 * std::ptrdiff_t(term.source)
                                 : received.data() + 3 * (term.source - end),
               values + 3 * std::ptrdiff_t(term.node));
}

HexMesh::SummationOrder NodeCopies::order(const std::vector<int> &group)
{
  std::vector<double> of_copies(3 * corners_.size(), 0.);
  for (std::size_t i = 0; i < corners_.size() && !group.empty(); ++i)
    of_copies[3 * i] = group[corners_[i].element];
  const auto &received = messages_.exchange(of_copies.data());
  const int end        = first_copy_ + static_cast<int>(corners_.size());
  for (auto &term : terms_)
    term.group = static_cast<int>(term.source < end ? of_copies[3 * (term.source - first_copy_)]
                                                    : received[3 * (term.source - end)]);
  std::sort(terms_.begin(), terms_.end(),
            [](const Term &a, const Term &b)
            { return std::tie(a.node, a.group, a.order) < std::tie(b.node, b.group, b.order); });
  HexMesh::SummationOrder order;
  for (const auto &term : terms_)
    order.terms.push_back({term.node, term.source});
  return order;
}

HangingSums::HangingSums(const MPI_Comm communicator, const HexMesh &mesh,
                         const std::vector<std::int64_t> &owner_ends)
{
  struct Sent
  {
    std::int64_t master, place;
  };
  const int n_ranks   = static_cast<int>(owner_ends.size());
  const auto &hanging = mesh.hanging_nodes();
  std::vector<std::vector<Sent>> sent(n_ranks);
  std::vector<std::vector<Share>> shares(n_ranks);
  for (std::size_t k = 0; k < hanging.node.size(); ++k)
  {
    const int node = hanging.node[k];
    if (node >= mesh.n_owned_nodes())
      continue;
    hanging_.push_back(node);
    const auto place = mesh.place_number(mesh.reference_position(node));
    for (int i = hanging.first[k]; i < hanging.first[k + 1]; ++i)
      if (const int master = hanging.master[i]; master < mesh.n_owned_nodes())
      {
        terms_.push_back({master, place, static_cast<int>(own_.size())});
        own_.push_back({node, hanging.weight[i]});
      }
      else
      {
        const auto global = mesh.global_node(master);
        const auto rank =
            std::upper_bound(owner_ends.begin(), owner_ends.end(), global) - owner_ends.begin();
        sent[rank].push_back({global, place});
        shares[rank].push_back({node, hanging.weight[i]});
      }
  }
  sent_              = joined(shares);
  const auto foreign = joined(exchange_lists(communicator, sent));
  for (auto &term : terms_)
    term.source += static_cast<int>(foreign.size());
  for (std::size_t i = 0; i < foreign.size(); ++i)
    terms_.push_back({static_cast<int>(foreign[i].master - mesh.first_owned_node()),
                      foreign[i].place, static_cast<int>(i)});
  std::sort(terms_.begin(), terms_.end(),
            [](const Term &a, const Term &b)
            { return std::tie(a.master, a.place) < std::tie(b.master, b.place); });
  std::vector<int> n_sent;
  n_sent.reserve(sent.size());
  for (const auto &list : sent)
    n_sent.push_back(static_cast<int>(list.size()));
  messages_ = TripleMessages(communicator, mpi_tag::hanging_sums, n_sent);
  packed_.resize(3 * sent_.size());
  own_values_.resize(3 * own_.size());
}

void HangingSums::hand_on(double *const values)
{
  // Weights are powers of two, so the products are exact.
  const auto pack = [&](const std::vector<Share> &shares, std::vector<double> &into)
  {
    for (std::size_t i = 0; i < shares.size(); ++i)
      for (int d = 0; d < 3; ++d)
        into[3 * i + d] = shares[i].weight * values[3 * std::ptrdiff_t(shares[i].node) + d];
  };
  pack(sent_, packed_);
  pack(own_, own_values_);
  const auto &received = messages_.exchange(packed_.data());
  const int n_foreign  = static_cast<int>(received.size() / 3);
  for (const auto &term : terms_)
    add_triple(term.source < n_foreign
                   ? received.data() + 3 * std::ptrdiff_t(term.source)
                   : own_values_.data() + 3 * std::ptrdiff_t(term.source - n_foreign),
               values + 3 * std::ptrdiff_t(term.master));
  for (const int node : hanging_)
    std::fill_n(values + 3 * std::ptrdiff_t(node), 3, 0.);
}
} // namespace ricochet
