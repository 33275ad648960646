// The state of a world as a list of its parts: what the writer of snapshots writes, with names and types. For looking
// at, not for speed.
#pragma once

#include "world/impl.h"

namespace sudar::inline SUDAR_PRECISION {

class StateList : public Writer {
 public:
  // Values side by side: an array by slot, or one value.
  struct Part {
    std::string path;    // "bodies.velocity"
    std::int64_t index;  // of the row that it belongs to; -1: none
    bool array;          // its elements are the rows
    PlainType type;
    std::vector<std::byte> bytes;

    Leaves leaves(std::size_t element_index) const {
      Leaves found;
      type.leaves(bytes.data() + element_index * type.size, found);
      return found;
    }
  };

  explicit StateList(const World::Impl& w) {
    w.write_state(*this);
    named("geometry", w.geometry);
  }
  const std::vector<Part>& parts() const { return parts_; }
  const Part* find(const std::string& path) const {
    const auto at = std::find_if(parts_.begin(), parts_.end(), [&](const Part& p) { return p.path == path; });
    return at == parts_.end() ? nullptr : &*at;
  }

 private:
  void text(const std::string& s) override {
    const auto* bytes = reinterpret_cast<const std::byte*>(s.c_str());
    const auto leaf = [](const void* value, Leaves& out) {
      out.push_back({"", "text", quoted(static_cast<const char*>(value))});
    };
    parts_.push_back({path_, index_, false, {s.size() + 1, leaf}, {bytes, bytes + s.size() + 1}});
  }
  void put_count(std::uint64_t count) override {
    enter("count");
    value(count);
    leave();
    in_array_ = true;
  }
  void put(const void* values, std::size_t count, const PlainType& type) override {
    const auto* bytes = static_cast<const std::byte*>(values);
    parts_.push_back({path_, index_, std::exchange(in_array_, false), type, {bytes, bytes + count * type.size}});
  }
  void enter(const char* name) override {
    in_array_ = false;
    lengths_.push_back(path_.size());
    path_ = part_path(path_, name);
  }
  void enter_element(const char* name, std::size_t i) override {
    enter(name);
    index_ = std::int64_t(i), depth_ = lengths_.size();
  }
  void leave() override {
    if (lengths_.size() == depth_) index_ = -1, depth_ = 0;
    path_.resize(lengths_.back());
    lengths_.pop_back();
  }

  std::vector<Part> parts_;
  std::string path_;
  std::vector<std::size_t> lengths_;  // of the path before each name in it
  std::int64_t index_ = -1;
  std::size_t depth_ = 0;  // of the name with which index_ ends
  bool in_array_ = false;
};

}
