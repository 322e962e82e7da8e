// SPDX-License-Identifier: LGPL-2.1-or-later
#include "ricochet/contact/contact_search.h"

#include "ricochet/base/exceptions.h"
#include "ricochet/base/exchange.h"
#include "ricochet/search/hybrid_search.h"
#include "ricochet/search/near_points.h"

#include <algorithm>
#include <limits>
#include <unordered_map>

namespace ricochet
{
ContactNumbering::ContactNumbering(const Bodies &bodies) :
  squared_range_(std::numeric_limits<int>::max())
{
  int first_place = 0;
  for (const auto &body : bodies)
  {
    const auto &stencil = body->lattice().stencil();
    const auto &n       = body->lattice().box().n;
    // Rows and planes are kept apart by the stencil's reach: a difference has one meaning only.
    Body numbers{2 * n[1] + stencil.reach, n[2] + stencil.reach, -n[1], {}};
    const auto difference = [&](const Stencil::Offset &o)
    { return (o.x * numbers.n_z + o.z) * numbers.n_y + o.y; };
    std::int64_t largest = 0;
    for (const auto &offset : stencil.offsets)
      largest = std::max(largest, difference(offset));
    numbers.offsets.assign(largest + 1, -1);
    for (std::size_t k = 0; k < stencil.offsets.size(); ++k)
      numbers.offsets[difference(stencil.offsets[k])] = static_cast<std::int16_t>(k);
    bodies_.push_back(std::move(numbers));
    first_place_.push_back(first_place);
    first_place += n[0] + 2 * stencil.reach; // out of reach for the body before
    squared_range_ = std::min(squared_range_, stencil.squared_range);
  }
}

std::int64_t ContactNumbering::id(const int body, const std::array<int, 3> &at) const
{
  const auto &b = bodies_[body];
  return (std::int64_t(body) << body_bits) + (at[0] * b.n_z + at[2]) * b.n_y + at[1] - b.first_y;
}

ContactNumbering::Place ContactNumbering::place(const std::int64_t id) const
{
  const int body         = static_cast<int>(id >> body_bits);
  const auto &b          = bodies_[body];
  const std::int64_t at  = id - (std::int64_t(body) << body_bits);
  const std::int64_t row = at / b.n_y;
  return {body,
          {static_cast<int>(row / b.n_z), static_cast<int>(at % b.n_y) + b.first_y,
           static_cast<int>(row % b.n_z)}};
}

Families ContactNumbering::families(const std::vector<std::int64_t> &ids) const
{
  Families families;
  families.squared_range = static_cast<float>(squared_range_);
  families.place.reserve(ids.size());
  for (const auto id : ids)
  {
    const Place at = place(id);
    families.place.push_back({static_cast<float>(first_place_[at.body] + at.lattice[0]),
                              static_cast<float>(at.lattice[1]),
                              static_cast<float>(at.lattice[2])});
  }
  return families;
}

namespace
{
// Points are searched by their reach, the slow ones first: a radius that suits the fastest fragment
// would bring up all of the slow ones' distant neighbours.
constexpr double level_limits[] = {0.25, 0.75, ContactSearch::largest_reach}; // [spacings]
constexpr int n_levels          = 3;

Vector3 position_of(const ContactPoint &point)
{
  return {point.position[0], point.position[1], point.position[2]};
}

bool is_of_level(const ContactPoint &point, const int level, const double spacing)
{
  return (level == 0 || point.reach > level_limits[level - 1] * spacing) &&
         point.reach <= level_limits[level] * spacing;
}

bool level_has_points(const std::vector<ContactPoint> &points, const int level,
                      const double spacing)
{
  return std::any_of(points.begin(), points.end(),
                     [&](const ContactPoint &point) { return is_of_level(point, level, spacing); });
}

/// The points up to a level, and which of them must be in a pair.
struct LevelPoints
{
  std::vector<std::int32_t> number; // among all points
  std::vector<Vector3> position;
  std::vector<char> active;
  std::vector<std::int64_t> id;
};

LevelPoints points_up_to_level(const std::vector<ContactPoint> &points, const std::size_t n_points,
                               const int level, const double spacing)
{
  LevelPoints result;
  result.number.reserve(n_points);
  result.position.reserve(n_points);
  result.active.reserve(n_points);
  result.id.reserve(n_points);
  for (std::size_t i = 0; i < n_points; ++i)
    if (points[i].reach <= level_limits[level] * spacing)
    {
      result.number.push_back(static_cast<std::int32_t>(i));
      result.position.push_back(position_of(points[i]));
      result.id.push_back(points[i].id);
      result.active.push_back(level > 0 ? is_of_level(points[i], level, spacing)
                                        : points[i].active);
    }
  return result;
}

double radius_of_level(const int level, const ContactSearch::Parameters &parameters)
{
  return parameters.range + 2. * level_limits[level] * parameters.spacing;
}

/// Every rank searches among its own points and those of other ranks that come near them.
class LocalContactSearch : public ContactSearch
{
public:
  LocalContactSearch(const std::string &name, const Parameters &parameters) :
    ContactSearch(parameters), search_(make_pair_search(name))
  {
  }

  void find(ContactCandidates &candidates) override
  {
    add_points_of_other_ranks(candidates);
    candidates.pairs.clear();
    for (int level = 0; level < n_levels; ++level)
    {
      if (!level_has_points(candidates.points, level, parameters_.spacing))
        continue;
      const auto points = points_up_to_level(candidates.points, candidates.points.size(), level,
                                             parameters_.spacing);
      search_->find(points.position, points.active, radius_of_level(level, parameters_), found_, {},
                    parameters_.numbering->families(points.id));
      for (const auto &pair : found_)
      {
        const std::int32_t a = points.number[pair.first], b = points.number[pair.second];
        if (static_cast<std::size_t>(std::min(a, b)) < candidates.n_own &&
            (candidates.points[a].active || candidates.points[b].active))
          candidates.pairs.push_back({a, b});
      }
    }
  }

private:
  void add_points_of_other_ranks(ContactCandidates &candidates) const
  {
    std::vector<Vector3> centres;
    std::vector<double> radii;
    int n_ranks;
    MPI_Comm_size(parameters_.communicator, &n_ranks);
    if (n_ranks == 1)
      return;
    for (const auto &point : candidates.points)
    {
      centres.push_back(position_of(point));
      radii.push_back(point.reach + 0.5 * parameters_.range);
    }
    const auto numbers =
        balls_near_other_ranks(parameters_.communicator, centres, radii, candidates.n_own,
                               /*cell=*/4. * parameters_.spacing);
    const auto others =
        joined(exchange_lists(parameters_.communicator, chosen(candidates.points, numbers)));
    candidates.points.insert(candidates.points.end(), others.begin(), others.end());
  }

  std::unique_ptr<PairSearch> search_;
  std::vector<PointPair> found_;
};

/// Points are handed out to blocks of space; what is found there goes home to the ranks whose
/// points they are.
class HybridContactSearch : public ContactSearch
{
public:
  explicit HybridContactSearch(const Parameters &parameters) :
    ContactSearch(parameters), search_(parameters.communicator)
  {
    MPI_Comm_rank(parameters.communicator, &rank_);
    MPI_Comm_size(parameters.communicator, &n_ranks_);
  }

  void find(ContactCandidates &candidates) override
  {
    candidates.pairs.clear();
    std::unordered_map<std::int64_t, std::int32_t> others; // their numbers by id
    for (int level = 0; level < n_levels; ++level)
    {
      int any = level_has_points(candidates.points, level, parameters_.spacing);
      MPI_Allreduce(MPI_IN_PLACE, &any, 1, MPI_INT, MPI_MAX, parameters_.communicator);
      if (any == 0)
        continue;
      for (const auto &partner : partners_of_level(candidates, level))
        candidates.pairs.push_back({partner.number, number_of(partner.point, candidates, others)});
    }
  }

private:
  /// What a rank is told about one of its points.
  struct Partner
  {
    std::int32_t number; // of the rank's point
    ContactPoint point;  // what is near it
  };

  std::vector<Partner> partners_of_level(const ContactCandidates &candidates, const int level)
  {
    const auto points =
        points_up_to_level(candidates.points, candidates.n_local, level, parameters_.spacing);
    std::vector<ContactPoint> own;
    std::vector<std::int64_t> ids;
    for (const auto i : points.number)
    {
      own.push_back(candidates.points[i]);
      ids.push_back((std::int64_t(rank_) << 32) | i);
    }
    search_.find(points.position, points.active, ids, radius_of_level(level, parameters_));
    const auto all = search_.distribute(own);

    std::vector<std::vector<Partner>> home(n_ranks_);
    for (const auto &pair : search_.pairs())
    {
      const ContactPoint &a = all[pair.first], &b = all[pair.second];
      if (!may_touch(a, b))
        continue;
      if (!a.image)
        home[a.rank].push_back({a.number, b});
      if (!b.image && (a.image || a.rank != b.rank))
        home[b.rank].push_back({b.number, a});
    }
    return joined(exchange_lists(parameters_.communicator, home));
  }

  /// Spares most messages; what remains is looked at again at home.
  bool may_touch(const ContactPoint &a, const ContactPoint &b) const
  {
    if (!a.active && !b.active)
      return false;
    const auto [lower, higher] = std::minmax(a.id, b.id);
    if (parameters_.numbering->offset(lower, higher) >= 0)
      return false;
    const double limit = parameters_.range + a.reach + b.reach;
    return (position_of(a) - position_of(b)).squaredNorm() < limit * limit;
  }

  std::int32_t number_of(const ContactPoint &point, ContactCandidates &candidates,
                         std::unordered_map<std::int64_t, std::int32_t> &others) const
  {
    if (point.rank == rank_)
      return point.number;
    const auto [entry, is_new] =
        others.emplace(point.id, static_cast<std::int32_t>(candidates.points.size()));
    if (is_new)
      candidates.points.push_back(point);
    return entry->second;
  }

  HybridSearch search_;
  int rank_, n_ranks_;
};

constexpr const char *hybrid = "hybrid";
} // namespace

std::vector<std::string> contact_search_names()
{
  std::vector<std::string> names;
  for (const auto &search : pair_searches())
    names.push_back(search.name);
  names.push_back(hybrid);
  return names;
}

std::unique_ptr<ContactSearch> make_contact_search(const std::string &name,
                                                   const ContactSearch::Parameters &parameters)
{
  if (name == hybrid)
    return std::make_unique<HybridContactSearch>(parameters);
  const auto names = contact_search_names();
  if (std::find(names.begin(), names.end(), name) != names.end())
    return std::make_unique<LocalContactSearch>(name, parameters);
  std::string known;
  for (const auto &one : names)
    known += (known.empty() ? "" : ", ") + one;
  throw InputError("There is no contact search '" + name + "'; choose one of: " + known + ".");
}
} // namespace ricochet
