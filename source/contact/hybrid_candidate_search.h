// SPDX-License-Identifier: LGPL-2.1-or-later
// Points are handed out to blocks of space (search/hybrid_search.h); what is found there goes home
// to the ranks whose points they are.
#pragma once

#include "candidate_search.h"
#include "ricochet/search/hybrid_search.h"

#include <unordered_map>

namespace ricochet
{
class HybridCandidateSearch : public CandidateSearch
{
public:
  explicit HybridCandidateSearch(const Parameters &parameters);

  void find(ContactCandidates &candidates) override;

private:
  /// What a rank is told about one of its points.
  struct Partner
  {
    std::int32_t number; // of the rank's point
    ContactPoint point;  // what is near it
  };

  std::vector<Partner> partners_of_level(const ContactCandidates &candidates, int level);
  /// Spares most messages; what remains is looked at again at home.
  bool may_touch(const ContactPoint &a, const ContactPoint &b) const;
  std::int32_t number_of(const ContactPoint &point, ContactCandidates &candidates,
                         std::unordered_map<std::int64_t, std::int32_t> &others) const;

  HybridSearch search_;
  int rank_, n_ranks_;
};
} // namespace ricochet
