#include <algorithm>
#include <bit>
#include <cstddef>

#include "csg/heavy_paths.hpp"

namespace raycat {

void HeavyPaths::State::start(const HeavyPaths& paths) {
  paths_ = &paths;
  slots_.resize(std::max(slots_.size(), paths.places_.size()));
  words_.resize(std::max(words_.size(), paths.words_.size()));
  if (++start_ == 0) {  // 2^32 starts ago, stamps were made that would be taken for new ones
    std::ranges::fill(slots_, Slot{});
    std::ranges::fill(words_, Word{});
    start_ = 1;
  }
  group_ = 0;
  in_group_ = false;
}

HeavyPaths::State::Slot& HeavyPaths::State::at(std::uint32_t slot) {
  Slot& found = slots_[slot];
  if (found.start != start_) {
    found = {.start = start_, .count = paths_->places_[slot].initial, .group = 0};
  }
  return found;
}

std::uint32_t HeavyPaths::State::count(std::uint32_t slot) const {
  return slots_[slot].start == start_ ? slots_[slot].count : paths_->places_[slot].initial;
}

std::uint64_t HeavyPaths::State::bits(std::uint32_t word) const {
  return words_[word].start == start_ ? words_[word].bits : paths_->words_[word];
}

HeavyPaths::State::Word& HeavyPaths::State::word(std::uint32_t index) {
  Word& found = words_[index];
  if (found.start != start_) {
    found = {.start = start_, .bits = paths_->words_[index]};
  }
  return found;
}

void HeavyPaths::State::set_decided(std::uint32_t slot, bool decided) {
  for (const std::uint32_t begin : paths_->level_begin_) {
    Word& changed = word(begin + slot / 64);
    const bool was_empty = changed.bits == 0;
    const std::uint64_t bit = std::uint64_t{1} << slot % 64;
    changed.bits = decided ? changed.bits | bit : changed.bits & ~bit;
    if (decided ? !was_empty : changed.bits != 0) {
      return;
    }
    slot /= 64;
  }
}

// The first decided node of the path from `slot` down. There is one: the leaf at its end.
std::uint32_t HeavyPaths::State::next_decided(std::uint32_t slot) const {
  const std::vector<std::uint32_t>& begin = paths_->level_begin_;
  std::size_t level = 0;
  std::uint64_t rest = bits(begin[0] + slot / 64) >> slot % 64;
  while (rest == 0) {
    slot = slot / 64 + 1;
    ++level;
    rest = bits(begin[level] + slot / 64) >> slot % 64;
  }
  slot += static_cast<std::uint32_t>(std::countr_zero(rest));
  while (level-- > 0) {
    slot = 64 * slot + static_cast<std::uint32_t>(std::countr_zero(bits(begin[level] + slot)));
  }
  return slot;
}

bool HeavyPaths::State::value_if_decided(std::uint32_t slot) const {
  const Kind kind = paths_->places_[slot].kind;
  return kind == Kind::leaf ? count(slot) != 0 : kind == Kind::any;
}

void HeavyPaths::State::touch(std::uint32_t slot, bool decided) {
  if (in_group_ && at(slot).group != group_) {
    at(slot).group = group_;
    const bool leaf = paths_->places_[slot].kind == Kind::leaf;
    touched_.push_back({.slot = slot, .decided = decided, .before = leaf && count(slot) != 0});
  }
}

bool HeavyPaths::State::toggle(std::uint32_t leaf) {
  std::uint32_t slot = paths_->slot_of_leaf_[leaf];
  touch(slot, true);
  Slot& bottom = at(slot);
  bottom.count ^= 1;
  const Place* place = &paths_->places_[slot];
  if (place->top != slot && next_decided(place->top) != slot) {
    return false;
  }
  bool value = bottom.count != 0;
  while (place->parent != no_slot) {
    slot = place->parent;
    place = &paths_->places_[slot];
    const bool fixed = place->kind == Kind::any;  // what the node is while decided
    const bool decided = value == fixed;
    std::uint32_t& deciding = at(slot).count;
    if (decided ? deciding++ > 0 : --deciding > 0) {
      return false;
    }
    touch(slot, !decided);
    const std::uint32_t first = next_decided(place->top);
    // What the node is while it is undecided is as the path goes on.
    const bool undecided =
        first < slot || value_if_decided(decided ? first : next_decided(slot + 1));
    set_decided(slot, decided);
    if (first < slot || undecided == fixed) {
      return false;
    }
    value = decided ? fixed : undecided;
  }
  return true;
}

bool HeavyPaths::State::inside() const { return value_if_decided(next_decided(0)); }

bool HeavyPaths::State::leaf_inside(std::uint32_t leaf) const {
  return (count(paths_->slot_of_leaf_[leaf]) != 0) != paths_->subtracted(leaf);
}

void HeavyPaths::State::begin_group() {
  touched_.clear();
  reaches_.clear();
  in_group_ = true;
  ++group_;
}

// Sets the values before and after of a path's touched nodes, which are in order. Nodes that were
// not touched are decided now if they were then.
void HeavyPaths::State::compare(std::span<Touched> path) {
  for (std::size_t i = path.size(); i-- > 0;) {
    Touched& node = path[i];
    const Kind kind = paths_->places_[node.slot].kind;
    if (kind == Kind::leaf) {
      node.after = count(node.slot) != 0;
      continue;
    }
    const std::uint32_t next = next_decided(node.slot + 1);
    const bool touched_next = i + 1 < path.size() && path[i + 1].slot <= next;
    const bool fixed = kind == Kind::any;
    const auto value = [&](bool decided, bool Touched::*when) {
      if (decided) {
        return fixed;
      }
      return touched_next ? path[i + 1].*when : value_if_decided(next);
    };
    node.before = value(node.decided, &Touched::before);
    node.after = value(count(node.slot) > 0, &Touched::after);
  }
}

// Notes how far down all nodes of a path changed. One that was not touched changed if it is
// undecided and the next one changed.
void HeavyPaths::State::reach(std::span<const Touched> path) {
  const std::uint32_t top = paths_->places_[path.front().slot].top;
  std::uint32_t from = top;
  bool any = false;
  std::uint32_t last = 0;
  for (const Touched& node : path) {
    if ((from < node.slot && next_decided(from) < node.slot) || node.before == node.after) {
      break;
    }
    any = true;
    last = node.slot;
    from = node.slot + 1;
  }
  if (any) {
    reaches_.push_back({.top = top, .last = last});
  }
}

void HeavyPaths::State::end_group() {
  in_group_ = false;
  std::ranges::sort(touched_, {}, &Touched::slot);
  for (std::size_t begin = 0; begin < touched_.size();) {
    const std::uint32_t top = paths_->places_[touched_[begin].slot].top;
    std::size_t end = begin + 1;
    while (end < touched_.size() && paths_->places_[touched_[end].slot].top == top) {
      ++end;
    }
    const std::span<Touched> nodes(touched_.data() + begin, end - begin);
    compare(nodes);
    reach(nodes);
    begin = end;
  }
}

bool HeavyPaths::State::responsible(std::uint32_t leaf) const {
  for (std::uint32_t slot = paths_->slot_of_leaf_[leaf]; slot != no_slot;) {
    const Place& place = paths_->places_[slot];
    const auto found = std::ranges::lower_bound(reaches_, place.top, {}, &Reach::top);
    if (found == reaches_.end() || found->top != place.top || found->last < slot) {
      return false;
    }
    slot = place.parent;
  }
  return true;
}

}  // namespace raycat
