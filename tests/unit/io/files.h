// Small files of our own making, written into a folder of their own, which goes with the test.
#pragma once

#include <gtest/gtest.h>

#include <sudar/io.h>

#include <unistd.h>

#include <fstream>

#include "unit/worlds.h"

namespace sudar_test {

class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "sudar_io_XXXXXX").string();
    path_ = mkdtemp(name.data());
  }
  ~Folder() { std::filesystem::remove_all(path_); }
  Folder(const Folder&) = delete;

  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    const std::filesystem::path path = path_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }

 private:
  std::filesystem::path path_;
};

class Files : public testing::Test {
 protected:
  std::filesystem::path write(const std::string& name, std::string_view bytes) const { return own_.write(name, bytes); }
  io::Reading read(const std::string& name, std::string_view bytes, const io::ReadOptions& options = {}) const {
    return io::read(write(name, bytes), options);
  }

 private:
  const Folder own_;

 protected:
  const std::filesystem::path& folder = own_.path();
};

// All findings from some severity on, a line each, without the folder.
inline std::string text_of(const io::Reading& r, io::Severity least = io::Severity::note) {
  std::string text;
  for (io::Finding f : r.findings) {
    if (f.severity < least) continue;
    f.at.file = std::filesystem::path(f.at.file).filename().string();
    text += io::text(f) + "\n";
  }
  return text;
}
inline bool says(const io::Reading& r, const std::string& what) { return text_of(r).find(what) != std::string::npos; }

}
