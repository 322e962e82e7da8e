// SPDX-License-Identifier: LGPL-2.1-or-later
// Every rank searches among its own points and those of other ranks that come near them.
#pragma once

#include "candidate_search.h"
#include "ricochet/search/pair_search.h"

namespace ricochet
{
class LocalCandidateSearch : public CandidateSearch
{
public:
  /// `name`: one of search/pair_search.h.
  LocalCandidateSearch(const std::string &name, const Parameters &parameters);

  void find(ContactCandidates &candidates) override;

private:
  void add_points_of_other_ranks(ContactCandidates &candidates) const;

  std::unique_ptr<PairSearch> search_;
  std::vector<PointPair> found_;
};
} // namespace ricochet
