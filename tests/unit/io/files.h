// Small files of our own making, written into a folder of their own, which goes with the test.
#pragma once

#include <gtest/gtest.h>

#include <sudar/io.h>

#include <unistd.h>

#include <fstream>

#include "unit/worlds.h"

namespace sudar_test {

class Files : public testing::Test {
 protected:
  Files() {
    std::string name = (std::filesystem::temp_directory_path() / "sudar_io_XXXXXX").string();
    folder = mkdtemp(name.data());
  }
  ~Files() override { std::filesystem::remove_all(folder); }

  std::filesystem::path write(const std::string& name, std::string_view bytes) const {
    const std::filesystem::path path = folder / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << bytes;
    return path;
  }
  io::Reading read(const std::string& name, std::string_view bytes, const io::ReadOptions& options = {}) const {
    return io::read(write(name, bytes), options);
  }

  std::filesystem::path folder;
};

// All findings, a line each, without the folder.
inline std::string text_of(const io::Reading& r) {
  std::string text;
  for (io::Finding f : r.findings) {
    f.at.file = std::filesystem::path(f.at.file).filename().string();
    text += io::text(f) + "\n";
  }
  return text;
}
inline bool says(const io::Reading& r, const std::string& what) { return text_of(r).find(what) != std::string::npos; }

}
