// SPDX-License-Identifier: LGPL-2.1-or-later
// Lists the pairs of points that may touch though no bond connects them, for
// contact/short_range_contact.h: two points of one body if their bond is broken, or if they never
// had one and at least one of them is open (damaged, or at the rim of a hole); points of different
// bodies always.
//
// Every few steps all pairs that can touch before the next search are listed: each point has a skin
// of its own (contact_skin.h). The few points that leave it earlier, fragments that something has
// hit, are searched again one by one; only when they are many, all are. So no contact is missed.
// Pairs whose bond is broken need no search in space, their bonds tell who they are. Pairs of two
// sound points are not listed far from damage; where a point there breaks a bond it is searched
// again too. Bonds that break are added at once. The lists have one order, so forces do not depend
// on when and how has been searched.
#pragma once

#include "broken_bond_pairs.h"
#include "contact_ghosts.h"
#include "contact_skin.h"

namespace ricochet
{
class ContactPairs
{
public:
  /// Two points that have never had a bond, by the numbers of their ghosts.
  struct NonBondedPair
  {
    std::int32_t a, b;
    bool one_body;
    double distance; // at which they touch [m]
  };

  /// The bodies must outlive this object. `mirrored`: y = 0 is a symmetry plane. `search`: one of
  /// contact_search_names(); throws InputError for another one.
  ContactPairs(MPI_Comm communicator, const Bodies &bodies, bool mirrored,
               const std::string &search);

  /// Sees to it that all pairs which touch are listed, and brings the ghosts of contact up to date;
  /// those of the bodies must be. `dt`: the coming step [s], which tells how far points may get
  /// before the pairs are searched again. Collective.
  void update(double dt);
  /// Points have appeared, or changed their flat index or rank: the next update searches all.
  void bodies_changed() { bodies_changed_ = true; }

  // The lists: pairs that touch and others.
  const PairList<BrokenBondPairs::Pair> &broken_bond_pairs(const std::size_t body) const
  {
    return broken_bond_pairs_[body].pairs();
  }
  const PairList<NonBondedPair> &non_bonded_pairs() const { return non_bonded_pairs_; } // by ids
  const ContactGhosts &ghosts() const { return ghosts_; }

  long n_searches() const { return n_searches_; }
  long n_single_searches() const { return n_single_searches_; }

private:
  /// A pair that may become one of the lists: a point of this rank and any other.
  struct NewPair
  {
    ContactPoint own, other;
  };

  void search_all(double dt);
  void search_single(const std::vector<ContactPoint> &points);
  void sort_non_bonded_pairs();
  void add(const ContactPoint &one, const ContactPoint &other);
  void add_non_bonded_pair(const ContactPoint &lower, const ContactPoint &higher);

  MPI_Comm communicator_;
  int rank_, n_ranks_;
  const Bodies &bodies_;
  bool mirrored_;
  ContactNumbering numbering_;
  double spacing_, range_; // the largest of all bodies, and at which any two points touch [m]
  std::unique_ptr<CandidateSearch> search_;
  ContactSkin skin_;

  bool bodies_changed_ = false;
  long n_searches_ = 0, n_single_searches_ = 0;
  std::vector<BrokenBondPairs> broken_bond_pairs_; // per body
  PairList<NonBondedPair> non_bonded_pairs_;
  ContactGhosts ghosts_;
};
} // namespace ricochet
