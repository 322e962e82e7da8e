// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists the pairs of points that may touch though no bond connects them, for the pair law of
// forces/debris_contact.h: two points of one body if their bond is broken, or if they never had one
// and at least one of them is damaged; points of different bodies always.
//
// Every few steps all pairs that can touch before the next search are listed: each point may travel
// its own reach, as far as its present speed suggests. The few points that leave their reach
// earlier, fragments that something has hit, are searched again one by one; only when they are
// many, all are. So no contact is missed, and fast fragments do not make the others' lists long or
// short-lived. Pairs of two sound points are not listed far from damage; where a point there breaks
// a bond it is searched again too. Bonds that break are added at once. The lists are kept in one
// order, so forces do not depend on when and how has been searched.
#pragma once

#include "ricochet/forces/contact_search.h"

#include <unordered_map>

namespace ricochet
{
class DebrisPairs
{
public:
  /// A pair of former neighbours: flat indices of one body.
  struct BondPair
  {
    std::int32_t p, q;
    double distance; // d [m]
  };
  /// Two points that have never been neighbours, by their numbers among the watched points.
  struct ForeignPair
  {
    std::int32_t a, b;
    bool one_body;
    double distance; // d [m]
  };
  /// A point of this rank, or its image across y = 0.
  struct Follower
  {
    std::int32_t flat; // index in the body's lattice; < 0: a point of another rank
    std::int16_t body;
    bool image;
  };
  /// A point of a foreign pair as it is now, on whichever rank it lives.
  struct Watched
  {
    double position[3]; // [m]
    double damaged;     // 0 or 1
    double velocity[3]; // half a step ago [m/s]
  };

  /// The bodies must outlive this object. `mirrored`: y = 0 is a symmetry plane. `search`: one of
  /// contact_search_names(); throws InputError for another one.
  DebrisPairs(MPI_Comm communicator, const Bodies &bodies, bool mirrored,
              const std::string &search);
  ~DebrisPairs();

  /// Sees to it that all pairs which touch are listed, and brings the watched points up to date;
  /// ghosts must be. `dt`: the coming step [s], which tells how far points may get before the pairs
  /// are searched again. Collective.
  void update(double dt);
  /// Points have appeared, or changed their flat index or rank: the next update searches all.
  void bodies_changed() { bodies_changed_ = true; }

  // The lists: pairs that touch and others; some may stand there twice.
  const std::vector<BondPair> &bond_pairs(const std::size_t body) const
  {
    return bond_pairs_[body];
  }
  const std::vector<ForeignPair> &foreign_pairs() const { return foreign_pairs_; }
  const Watched &watched(const std::int32_t number) const { return watched_[number]; }
  const Follower &follower(const std::int32_t number) const { return followers_[number]; }
  /// In ContactNumbering.
  std::int64_t id(const std::int32_t number) const { return watched_points_[number].id; }
  int body(const std::int32_t number) const { return followers_[number].body; }

  long n_searches() const { return n_searches_; }
  long n_single_searches() const { return n_single_searches_; }

private:
  struct Box
  {
    double low[3], high[3]; // [m]
  };
  /// Where a body's points were when they were last searched, how far they may get from there, and
  /// whether all their pairs are known or only those with points that are active themselves.
  struct Journey
  {
    std::vector<double> start[3]; // [m], from the first owned entry on; NaN where there is no point
    std::vector<double> reach;    // [m]
    std::vector<char> active;
    std::vector<Box> boxes;               // of `chunk` entries each: the points in them stay inside
    std::vector<std::ptrdiff_t> occupied; // first entries of the chunks with any point
  };
  /// A pair that may become one of the lists: a point of this rank and any other.
  struct NewPair
  {
    ContactPoint own, other;
  };

  double contact_distance(double reference_distance, double spacing) const; // d [m]
  void start_journey(std::size_t body, std::ptrdiff_t p, double dt);
  void list_pairs(double dt);
  std::vector<ContactPoint> strays(double dt);
  void append_broken();
  void search_all(double dt);
  void search_again(const std::vector<ContactPoint> &strays);
  std::vector<ContactPoint> points_near(const ContactPoint &point) const;
  void begin_journeys(double dt);
  void mark_active_near_damage(std::size_t body);
  void mark_active_in_box(std::size_t body, const double *corner);
  ContactPoint contact_point(std::size_t body, std::ptrdiff_t p,
                             const std::array<int, 3> &place) const;
  ContactPoint image_of(ContactPoint point) const;
  void add_own_points(ContactCandidates &candidates) const;
  void add_images(ContactCandidates &candidates) const;
  void add(const ContactPoint &one, const ContactPoint &other);
  void add_bond_pair(const ContactPoint &lower, const ContactPoint &higher, int offset);
  void add_foreign_pair(const ContactPoint &lower, const ContactPoint &higher);
  std::int32_t number_of(const ContactPoint &point);
  void watch();
  Watched look_at(const Follower &follower) const;
  void update_watched();

  MPI_Comm communicator_;
  int rank_, n_ranks_;
  const Bodies &bodies_;
  bool mirrored_;
  ContactNumbering numbering_;
  double spacing_, range_; // the largest dx and d of all bodies [m]
  std::unique_ptr<ContactSearch> search_;

  bool bodies_changed_ = false;
  long n_searches_ = 0, n_single_searches_ = 0;
  std::vector<Journey> journeys_;                 // per body
  std::vector<std::vector<BondPair>> bond_pairs_; // per body; some may be listed twice
  std::vector<ForeignPair> foreign_pairs_;        // likewise
  std::vector<ContactPoint> watched_points_;      // as they were when found
  std::unordered_map<std::int64_t, std::int32_t> watched_numbers_; // by id
  std::vector<Watched> watched_;
  std::vector<Follower> followers_;                   // what watched_ follows
  std::vector<std::vector<std::int32_t>> watched_of_; // other ranks' points, per rank
  std::vector<std::vector<Follower>> watched_by_;     // this rank's points, per rank
};
} // namespace ricochet
