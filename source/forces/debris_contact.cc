// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/forces/debris_contact.h"

#include "ricochet/geometry/linked_cells.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace ricochet
{
/// Own points first, then those of other ranks, then mirror images of both.
struct DebrisContact::Cloud
{
  struct Point
  {
    std::int64_t id; // global, orders the pairs alike on all ranks
    std::int32_t body;
    std::int32_t lattice[3]; // coordinates, y negative for an image
    std::int32_t damaged;
  };
  static_assert(sizeof(Point) == 32, "sent as bytes");

  std::vector<Point> points;
  std::vector<Vector3> position;
  std::vector<std::ptrdiff_t> flat; // index in the body's lattice, own points only
  std::vector<int> original;        // of each image
  std::size_t n_own = 0, n_real = 0;

  // Own points sent to each rank, and how many come back.
  std::vector<std::vector<int>> send;
  std::vector<int> receive;

  void clear() { *this = Cloud(); }
};

namespace
{
/// k = factor 18 K V^2 / (pi delta^5) [N/m]
double pair_stiffness(const PeridynamicForce &body, const double factor)
{
  const auto &stencil = body.lattice().stencil();
  const double volume = std::pow(stencil.spacing, 3);
  return factor * 18. * body.material().bulk_modulus / (M_PI * std::pow(stencil.horizon, 5)) *
         volume * volume;
}

using Box = std::pair<Vector3, Vector3>;

const Box empty_box{Vector3::Constant(std::numeric_limits<double>::max()),
                    Vector3::Constant(-std::numeric_limits<double>::max())};

void extend(Box &box, const Vector3 &x)
{
  box.first  = box.first.cwiseMin(x);
  box.second = box.second.cwiseMax(x);
}

bool is_empty(const Box &box)
{
  return box.first.x() > box.second.x();
}

void extend(Box &box, const Box &other)
{
  if (!is_empty(other))
  {
    extend(box, other.first);
    extend(box, other.second);
  }
}

void extend_by_image(Box &box)
{
  if (!is_empty(box))
  {
    const double low = box.first.y(), high = box.second.y();
    box.first.y()  = std::min(low, -high);
    box.second.y() = std::max(high, -low);
  }
}

bool inside(const Box &box, const Vector3 &x, const double margin)
{
  return (x.array() >= box.first.array() - margin).all() &&
         (x.array() <= box.second.array() + margin).all();
}

Vector3 position_of(const LatticeArrays &a, const std::ptrdiff_t p)
{
  return {a.position[0][p], a.position[1][p], a.position[2][p]};
}

/// Boxes of all ranks. Collective.
std::vector<Box> gather(const MPI_Comm communicator, const Box &own)
{
  int n_ranks;
  MPI_Comm_size(communicator, &n_ranks);
  std::vector<Box> all(n_ranks);
  MPI_Allgather(&own, sizeof(Box), MPI_BYTE, all.data(), sizeof(Box), MPI_BYTE, communicator);
  return all;
}
} // namespace

DebrisContact::DebrisContact(const MPI_Comm communicator,
                             const std::vector<std::unique_ptr<PeridynamicForce>> &bodies,
                             const double factor, const bool mirrored) :
  communicator_(communicator),
  bodies_(bodies), factor_(factor), mirrored_(mirrored), bond_pairs_(bodies.size()),
  cloud_(std::make_unique<Cloud>())
{
  skin_ = std::numeric_limits<double>::max();
  for (const auto &body : bodies)
  {
    skin_ = std::min(skin_, body->lattice().box().spacing);
    stiffness_.push_back(pair_stiffness(*body, factor));
  }
}

DebrisContact::~DebrisContact() = default;

double DebrisContact::contact_distance(const double reference_distance, const double spacing) const
{
  return std::min(0.9 * reference_distance, 1.35 * spacing);
}

double DebrisContact::squared_frequency(const PeridynamicForce &body) const
{
  // In compact debris about six neighbours push at once; two neighbours in antiphase double the
  // stiffness.
  return 2. * 6. * pair_stiffness(body, factor_) / body.point_mass();
}

void DebrisContact::evaluate(const double dt)
{
  if (factor_ <= 0.)
    return;
  double fastest = 0.;
  for (const auto &body : bodies_)
  {
    const auto &a    = body->state().arrays;
    const Lattice &l = body->lattice();
    for (std::ptrdiff_t p = l.owned_begin(); p < l.owned_end(); ++p)
      if (body->is_damaged(p) || bodies_.size() > 1)
        fastest = std::max(fastest, a.velocity[0][p] * a.velocity[0][p] +
                                        a.velocity[1][p] * a.velocity[1][p] +
                                        a.velocity[2][p] * a.velocity[2][p]);
  }
  MPI_Allreduce(MPI_IN_PLACE, &fastest, 1, MPI_DOUBLE, MPI_MAX, communicator_);
  // The positions have already moved with these velocities.
  travelled_ += 2. * dt * std::sqrt(fastest);
  if (!searched_ || travelled_ > skin_)
    refresh();
  else
  {
    append_broken();
    update_cloud();
  }

  for_each_contact(
      [](LatticeArrays *a, const std::ptrdiff_t p, LatticeArrays *b, const std::ptrdiff_t q,
         const Vector3 &force, double, const Lattice *, const Lattice *)
      {
        for (int d = 0; d < 3; ++d)
        {
          if (a)
            a->force[d][p] -= force[d];
          if (b)
            b->force[d][q] += force[d];
        }
      });
}

/// Calls visit(arrays of i or null, i, arrays of j or null, j, force on j, energy, lattice of i,
/// lattice of j); null where the point is not this rank's.
template <class Visitor>
void DebrisContact::for_each_contact(Visitor &&visit) const
{
  for (std::size_t body = 0; body < bodies_.size(); ++body)
  {
    auto &a          = bodies_[body]->state().arrays;
    const Lattice &l = bodies_[body]->lattice();
    const double k   = stiffness_[body];
    for (const auto &pair : bond_pairs_[body])
    {
      const Vector3 d      = position_of(a, pair.q) - position_of(a, pair.p);
      const double squared = d.squaredNorm();
      if (squared >= pair.distance * pair.distance || squared == 0.)
        continue;
      const double r       = std::sqrt(squared);
      const double overlap = pair.distance - r;
      visit(l.owned(pair.p) ? &a : nullptr, pair.p, l.owned(pair.q) ? &a : nullptr, pair.q,
            Vector3(k * overlap / r * d), 0.5 * k * overlap * overlap, &l, &l);
    }
  }
  const auto &c = *cloud_;
  for (const auto &pair : foreign_pairs_)
  {
    const Vector3 d      = c.position[pair.b] - c.position[pair.a];
    const double squared = d.squaredNorm();
    if (squared >= pair.distance * pair.distance || squared == 0.)
      continue;
    const double r       = std::sqrt(squared);
    const double overlap = pair.distance - r;
    const auto own = [&](const std::int32_t i) { return static_cast<std::size_t>(i) < c.n_own; };
    auto &first    = *bodies_[c.points[pair.a].body];
    auto &second   = *bodies_[c.points[pair.b].body];
    visit(own(pair.a) ? &first.state().arrays : nullptr, own(pair.a) ? c.flat[pair.a] : 0,
          own(pair.b) ? &second.state().arrays : nullptr, own(pair.b) ? c.flat[pair.b] : 0,
          Vector3(pair.stiffness * overlap / r * d), 0.5 * pair.stiffness * overlap * overlap,
          &first.lattice(), &second.lattice());
  }
}

double DebrisContact::energy() const
{
  int n_planes = 0;
  for (const auto &body : bodies_)
    n_planes = std::max(n_planes, body->lattice().box().n[0]);
  PlaneSums<1> sums(n_planes);
  for_each_contact(
      [&](const LatticeArrays *a, const std::ptrdiff_t p, const LatticeArrays *b,
          const std::ptrdiff_t q, const Vector3 &, const double energy, const Lattice *first,
          const Lattice *second)
      {
        if (a)
          sums[first->plane_of(p)][0] += 0.5 * energy;
        if (b)
          sums[second->plane_of(q)][0] += 0.5 * energy;
      });
  return (mirrored_ ? 2. : 1.) * sums.total(communicator_)[0];
}

void DebrisContact::append_broken()
{
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const auto &body    = *bodies_[i];
    const auto &stencil = body.lattice().stencil();
    for (std::size_t n = 0; n < body.n_broken_entries(); ++n)
    {
      const auto &entry  = body.broken()[n];
      const auto &offset = stencil.offsets[entry.offset];
      const auto shift   = body.lattice().shift(offset);
      const double d     = contact_distance(offset.length, stencil.spacing);
      for (int lane = 0; lane < Lattice::block_size; ++lane)
        if ((entry.points >> lane) & 1)
        {
          const std::int32_t p = entry.block * Lattice::block_size + lane;
          bond_pairs_[i].push_back({p, static_cast<std::int32_t>(p + shift), d});
        }
    }
  }
}

void DebrisContact::refresh()
{
  travelled_ = 0.;
  searched_  = true;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const auto &body    = *bodies_[i];
    const auto &stencil = body.lattice().stencil();
    const auto &a       = body.state().arrays;
    auto &pairs         = bond_pairs_[i];
    pairs.clear();
    body.for_each_broken_bond(
        [&](const std::ptrdiff_t p, const std::ptrdiff_t q, const std::size_t k)
        {
          const double d = contact_distance(stencil.offsets[k].length, stencil.spacing);
          if ((position_of(a, q) - position_of(a, p)).squaredNorm() < (d + skin_) * (d + skin_))
            pairs.push_back({static_cast<std::int32_t>(p), static_cast<std::int32_t>(q), d});
        });
  }
  search();
}

void DebrisContact::search()
{
  auto &c = *cloud_;
  c.clear();
  foreign_pairs_.clear();
  double spacing = 0.;
  for (const auto &body : bodies_)
    spacing = std::max(spacing, body->lattice().box().spacing);
  const double range = 1.35 * spacing + skin_;

  // Undamaged surface points matter only where debris or another body is near.
  std::vector<Box> near(bodies_.size(), empty_box);
  bool anything = bodies_.size() > 1;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const Lattice &l = bodies_[i]->lattice();
    Box debris = empty_box, all = empty_box;
    for (std::ptrdiff_t p = l.owned_begin(); p < l.owned_end(); ++p)
      if (l.owned(p))
      {
        const Vector3 x = position_of(bodies_[i]->state().arrays, p);
        extend(all, x);
        if (bodies_[i]->is_damaged(p))
          extend(debris, x);
      }
    if (mirrored_)
      for (Box *box : {&debris, &all})
        extend_by_image(*box);
    for (const auto &box : gather(communicator_, debris))
    {
      extend(near[i], box);
      anything = anything || !is_empty(box);
    }
    const auto boxes = gather(communicator_, all);
    for (std::size_t j = 0; j < bodies_.size(); ++j)
      if (j != i)
        for (const auto &box : boxes)
          extend(near[j], box);
  }
  if (!anything)
    return;

  Box own_box = empty_box;
  for (std::size_t i = 0; i < bodies_.size(); ++i)
  {
    const auto &body = *bodies_[i];
    const Lattice &l = body.lattice();
    const auto &n    = l.box().n;
    for (std::ptrdiff_t p = l.owned_begin(); p < l.owned_end(); ++p)
    {
      if (!l.owned(p))
        continue;
      const Vector3 x    = position_of(body.state().arrays, p);
      const bool damaged = body.is_damaged(p);
      if (!damaged && !(body.is_surface(p) && inside(near[i], x, range)))
        continue;
      const auto at = l.coordinates(p);
      const auto id =
          ((static_cast<std::int64_t>(i) * (1 << 20) + at[0]) * n[2] + at[2]) * (2 * n[1]) + at[1] +
          n[1];
      c.points.push_back({id, static_cast<std::int32_t>(i), {at[0], at[1], at[2]}, damaged});
      c.position.push_back(x);
      c.flat.push_back(p);
      extend(own_box, x);
    }
  }
  c.n_own = c.points.size();

  // Every rank gets the points within range of its own.
  int rank, n_ranks;
  MPI_Comm_rank(communicator_, &rank);
  MPI_Comm_size(communicator_, &n_ranks);
  c.send.resize(n_ranks);
  c.receive.assign(n_ranks, 0);
  if (n_ranks > 1)
  {
    // A rank also needs the points whose images come near its own.
    Box wanted = own_box;
    if (mirrored_)
      extend_by_image(wanted);
    const auto boxes = gather(communicator_, wanted);
    std::vector<int> n_send(n_ranks), from(n_ranks), to(n_ranks), bytes_send(n_ranks),
        bytes_receive(n_ranks);
    std::vector<Cloud::Point> out;
    for (int r = 0; r < n_ranks; ++r)
    {
      from[r] = static_cast<int>(out.size() * sizeof(Cloud::Point));
      for (std::size_t i = 0; i < c.n_own && r != rank; ++i)
        if (inside(boxes[r], c.position[i], range))
        {
          c.send[r].push_back(static_cast<int>(i));
          out.push_back(c.points[i]);
        }
      n_send[r]     = static_cast<int>(c.send[r].size());
      bytes_send[r] = n_send[r] * static_cast<int>(sizeof(Cloud::Point));
    }
    MPI_Alltoall(n_send.data(), 1, MPI_INT, c.receive.data(), 1, MPI_INT, communicator_);
    int n_received = 0;
    for (int r = 0; r < n_ranks; ++r)
    {
      to[r]            = n_received * static_cast<int>(sizeof(Cloud::Point));
      bytes_receive[r] = c.receive[r] * static_cast<int>(sizeof(Cloud::Point));
      n_received += c.receive[r];
    }
    c.points.resize(c.n_own + n_received);
    MPI_Alltoallv(out.data(), bytes_send.data(), from.data(), MPI_BYTE, c.points.data() + c.n_own,
                  bytes_receive.data(), to.data(), MPI_BYTE, communicator_);
  }
  c.n_real = c.points.size();
  c.position.resize(c.n_real);
  update_cloud();
  // Own debris that has crossed the plane, y < 0, meets images of points further away from it.
  const double farthest_image = range + std::max(0., -own_box.first.y());
  if (mirrored_)
    for (std::size_t i = 0; i < c.n_real; ++i)
      if (c.position[i].y() < farthest_image)
      {
        auto image = c.points[i];
        image.id -= 2 * image.lattice[1] + 1;
        image.lattice[1] = -1 - image.lattice[1];
        c.points.push_back(image);
        c.original.push_back(static_cast<int>(i));
      }
  update_cloud();

  const auto reference = [&](const Cloud::Point &point)
  {
    return bodies_[point.body]->lattice().reference_position(
        {point.lattice[0], point.lattice[1], point.lattice[2]});
  };
  // Two undamaged points of the same body cannot touch.
  std::vector<char> active;
  for (const auto &point : c.points)
    active.push_back(point.damaged || bodies_.size() > 1);
  LinkedCells(c.position, active, range)
      .for_each_pair(
          [&](int a, int b)
          {
            if (c.points[b].id < c.points[a].id)
              std::swap(a, b);
            const auto &first = c.points[a], &second = c.points[b];
            if (static_cast<std::size_t>(a) >= c.n_own && static_cast<std::size_t>(b) >= c.n_own)
              return;
            const auto &body = *bodies_[first.body];
            double k = stiffness_[first.body], spacing_of_pair = body.lattice().box().spacing;
            if (first.body == second.body)
            {
              int squared = 0;
              for (int d = 0; d < 3; ++d)
                squared +=
                    (first.lattice[d] - second.lattice[d]) * (first.lattice[d] - second.lattice[d]);
              if (squared <= body.lattice().stencil().squared_range ||
                  !(first.damaged || second.damaged))
                return;
            }
            else
            {
              const auto &other = *bodies_[second.body];
              const double k2   = stiffness_[second.body];
              k                 = 2. * k * k2 / (k + k2);
              spacing_of_pair   = 0.5 * (spacing_of_pair + other.lattice().box().spacing);
            }
            const double d =
                contact_distance((reference(first) - reference(second)).norm(), spacing_of_pair);
            if ((c.position[a] - c.position[b]).squaredNorm() < (d + skin_) * (d + skin_))
              foreign_pairs_.push_back({a, b, d, k});
          });
  // The same order on any number of ranks, hence the same sums.
  std::sort(foreign_pairs_.begin(), foreign_pairs_.end(),
            [&](const ForeignPair &x, const ForeignPair &y)
            {
              const auto &p = c.points;
              return p[x.a].id != p[y.a].id ? p[x.a].id < p[y.a].id : p[x.b].id < p[y.b].id;
            });
}

void DebrisContact::update_cloud()
{
  auto &c = *cloud_;
  for (std::size_t i = 0; i < c.n_own; ++i)
    c.position[i] = position_of(bodies_[c.points[i].body]->state().arrays, c.flat[i]);

  const int n_ranks = static_cast<int>(c.send.size());
  std::vector<MPI_Request> requests;
  std::vector<std::vector<Vector3>> out(n_ranks);
  std::size_t at = c.n_own;
  for (int r = 0; r < n_ranks; ++r)
    if (c.receive[r] > 0)
    {
      MPI_Irecv(c.position[at].data(), 3 * c.receive[r], MPI_DOUBLE, r, 1000, communicator_,
                &requests.emplace_back());
      at += c.receive[r];
    }
  for (int r = 0; r < n_ranks; ++r)
    if (!c.send[r].empty())
    {
      for (const int i : c.send[r])
        out[r].push_back(c.position[i]);
      MPI_Isend(out[r][0].data(), 3 * static_cast<int>(out[r].size()), MPI_DOUBLE, r, 1000,
                communicator_, &requests.emplace_back());
    }
  MPI_Waitall(static_cast<int>(requests.size()), requests.data(), MPI_STATUSES_IGNORE);

  c.position.resize(c.n_real + c.original.size());
  for (std::size_t i = 0; i < c.original.size(); ++i)
  {
    c.position[c.n_real + i] = c.position[c.original[i]];
    c.position[c.n_real + i].y() *= -1.;
  }
}
} // namespace ricochet
