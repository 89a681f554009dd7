#pragma once

#include <cstdint>
#include <numeric>
#include <span>
#include <vector>

namespace palpate {

// Items in groups that are numbered from 0, stored end to end.
template <class Item>
struct Groups {
  std::vector<std::uint32_t> begin;  // one more than there are groups; or empty
  std::vector<Item> items;

  std::size_t size() const { return begin.empty() ? 0 : begin.size() - 1; }
  std::span<Item> operator[](std::size_t group) {
    return {items.data() + begin[group], items.data() + begin[group + 1]};
  }
  std::span<const Item> operator[](std::size_t group) const {
    return {items.data() + begin[group], items.data() + begin[group + 1]};
  }
};

// Groups items by counting, in linear time; within a group they keep their order. `visit(emit)` calls
// emit(group, item) for every item; it runs twice and must do the same both times.
template <class Item, class Visit>
Groups<Item> group_items(std::size_t group_count, const Visit& visit) {
  Groups<Item> groups;
  groups.begin.assign(group_count + 1, 0);
  visit([&](std::uint32_t group, const Item&) { ++groups.begin[group + 1]; });
  std::partial_sum(groups.begin.begin(), groups.begin.end(), groups.begin.begin());
  groups.items.resize(groups.begin.back());
  std::vector<std::uint32_t> next(groups.begin.begin(), groups.begin.end() - 1);
  visit([&](std::uint32_t group, const Item& item) { groups.items[next[group]++] = item; });
  return groups;
}

using IndexLists = Groups<std::uint32_t>;

}  // namespace palpate
