// Which items hang on which owners, where every item has two: the joints of a body, the pairs of a shape. Doubly linked
// lists through two arrays: an item joins and leaves its owners' lists at a constant cost, however long they are.
#pragma once

#include <array>
#include <cstdint>
#include <vector>

#include <sudar/base.h>

#include "base/room.h"

namespace sudar::inline SUDAR_PRECISION {

class Links {
 public:
  static constexpr std::uint32_t nobody = 0xffffffffu;  // an owner that keeps no list

  void add(std::uint32_t item, std::uint32_t a, std::uint32_t b) {
    if (item >= ends_.size() / 2) ends_.resize(2 * std::size_t(item) + 2);
    attach(2 * item, a);
    attach(2 * item + 1, b);
  }
  void remove(std::uint32_t item) {
    detach(2 * item);
    detach(2 * item + 1);
  }
  // Makes room for owners below `count`, so that the first item of one costs nothing more.
  void reserve(std::uint32_t count) {
    make_room(lists_, count);
  }
  std::uint32_t count(std::uint32_t owner) const { return owner < lists_.size() ? lists_[owner].count : 0; }

  // visit(item) for every item of the owner, the latest first. The item visited may be removed, no other.
  template <class Visit>
  void each(std::uint32_t owner, Visit visit) const {
    if (owner >= lists_.size()) return;
    for (std::uint32_t end = lists_[owner].first; end != none;) {
      const std::uint32_t next = ends_[end].next;
      visit(end / 2);
      end = next;
    }
  }
  // The first item of the owner, or nobody.
  std::uint32_t first(std::uint32_t owner) const {
    return owner < lists_.size() && lists_[owner].first != none ? lists_[owner].first / 2 : nobody;
  }
  void clear() { ends_.clear(), lists_.clear(); }

 private:
  static constexpr std::uint32_t none = nobody;
  struct End {
    std::uint32_t next = none, previous = none, owner = nobody;
  };
  struct List {
    std::uint32_t first = none, count = 0;
  };

  void attach(std::uint32_t end, std::uint32_t owner) {
    ends_[end] = {none, none, owner};
    if (owner == nobody) return;
    make_room(lists_, std::size_t(owner) + 1);
    List& list = lists_[owner];
    if (list.first != none) ends_[list.first].previous = end;
    ends_[end].next = list.first;
    list.first = end;
    ++list.count;
  }
  void detach(std::uint32_t end) {
    const End e = ends_[end];
    if (e.owner == nobody) return;
    if (e.next != none) ends_[e.next].previous = e.previous;
    if (e.previous != none) ends_[e.previous].next = e.next;
    else lists_[e.owner].first = e.next;
    --lists_[e.owner].count;
    ends_[end] = {};
  }

  std::vector<End> ends_;    // two an item
  std::vector<List> lists_;  // by owner
};

}
