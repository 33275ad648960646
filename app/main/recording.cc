#include "main/recording.h"

namespace sudar::app {

Recording::Recording(const std::string& path, World& world, const std::string& title)
    : file_(path), recorder_(world, title) {
  append(recorder_.open_bytes());
}

void Recording::append(std::span<const std::byte> whole) {
  file_.append(whole.subspan(written_));
  written_ = whole.size();
}

void Recording::after_step() {
  recorder_.after_step();
  append(recorder_.open_bytes());
  ++steps_;
}

void Recording::finish() {
  const Bytes whole = recorder_.bytes();
  append(whole);
  file_.finish(std::span(whole).first(Recorder::head));
}

}
