// The largest matching of a bipartite graph by augmenting paths (H. W. Kuhn, "The Hungarian Method for the
// Assignment Problem", 1955). Most sets are like one other alone, so that paths are short.
#include "samples/cli/set_matching.h"

#include <cmath>

#include "samples/cli/contacts.h"

namespace palpate::cli {
namespace {

constexpr std::size_t kNone = static_cast<std::size_t>(-1);

bool near(const double (&one)[3], const double (&other)[3], double reach) {
  return std::hypot(one[0] - other[0], one[1] - other[1], one[2] - other[2]) <= reach;
}

bool same_place(const plp_lmd& one, const plp_lmd& other, double reach) {
  return near(one.point_a, other.point_a, reach) && near(one.point_b, other.point_b, reach);
}

void add_once(std::vector<std::size_t>& sets, std::size_t set) {
  for (const std::size_t known : sets)
    if (known == set) return;
  sets.push_back(set);
}

}  // namespace

SetMatching::SetMatching(const plp_contacts& one, const plp_contacts& other, double reach)
    : alike_(one.set_count), partner_(other.set_count, kNone) {
  for (std::size_t i = 0; i < one.lmd_count; ++i)
    for (std::size_t k = 0; k < other.lmd_count; ++k)
      if (same_place(lmd_at(one, i), lmd_at(other, k), reach))
        add_once(alike_[lmd_at(one, i).set], lmd_at(other, k).set);
  for (std::size_t set = 0; set < alike_.size(); ++set) {
    std::vector<bool> asked(partner_.size(), false);
    pairs_ += find_partner(set, asked);
  }
}

// Takes a free one, or one whose partner finds another.
bool SetMatching::find_partner(std::size_t set, std::vector<bool>& asked) {
  for (const std::size_t candidate : alike_[set]) {
    if (asked[candidate]) continue;
    asked[candidate] = true;
    if (partner_[candidate] != kNone && !find_partner(partner_[candidate], asked)) continue;
    partner_[candidate] = set;
    return true;
  }
  return false;
}

}  // namespace palpate::cli
