#include "main/files.h"

#include <fcntl.h>
#include <sys/stat.h>
#include <unistd.h>

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <utility>

namespace sudar::app {

namespace {

namespace fs = std::filesystem;

std::string why() { return std::strerror(errno); }

// Devices and pipes are written to directly: they cannot be replaced.
bool is_device(const std::string& path) {
  struct stat s;
  return stat(path.c_str(), &s) == 0 && !S_ISREG(s.st_mode) && !S_ISDIR(s.st_mode);
}

bool write_all(int file, std::span<const std::byte> bytes) {
  while (!bytes.empty()) {
    const ssize_t n = write(file, bytes.data(), bytes.size());
    if (n < 0 && errno == EINTR) continue;
    if (n <= 0) return false;
    bytes = bytes.subspan(std::size_t(n));
  }
  return true;
}

}

Bytes read_file(const std::string& path) {
  struct stat s;
  if (stat(path.c_str(), &s) != 0) {
    throw Error(path, errno == ENOENT ? "there is no such file" : "cannot be read (" + why() + ")");
  }
  if (S_ISDIR(s.st_mode)) throw Error(path, "is a folder, a file expected");
  if (!S_ISREG(s.st_mode)) throw Error(path, "is no regular file");
  const int file = open(path.c_str(), O_RDONLY | O_CLOEXEC);
  if (file < 0) throw Error(path, "cannot be read (" + why() + ")");
  Bytes bytes(std::size_t(s.st_size));
  std::size_t done = 0;
  for (ssize_t n = 1; n > 0 && done < bytes.size(); done += std::size_t(n > 0 ? n : 0)) {
    n = read(file, bytes.data() + done, bytes.size() - done);
  }
  close(file);
  if (done < bytes.size()) throw Error(path, "cannot be read whole (" + why() + ")");
  return bytes;
}

void expect_writable(const std::string& path) {
  std::error_code error;
  if (fs::is_directory(path, error)) throw Error(path, "is a folder, a name for a file expected");
  const fs::path folder = fs::path(path).parent_path();
  if (folder.empty() || fs::is_directory(folder, error)) return;
  throw Error(path, "cannot be written: there is no folder " + folder.string());
}

void write_file(const std::string& path, std::span<const std::byte> bytes) {
  expect_writable(path);
  const bool device = is_device(path);
  const std::string partial = device ? path : path + ".part";
  const int file = open(partial.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  bool good = file >= 0 && write_all(file, bytes);
  std::string reason = why();
  if (file >= 0 && close(file) != 0 && good) good = false, reason = why();
  if (good && !device && std::rename(partial.c_str(), path.c_str()) != 0) good = false, reason = why();
  if (good) return;
  if (file >= 0 && !device) std::remove(partial.c_str());
  throw Error(path, "cannot be written (" + reason + ")");
}

std::string unused_name(const std::string& stem, const std::string& extension) {
  std::error_code error;
  fs::create_directories("out", error);
  if (error) throw Error("out", "the folder cannot be made (" + error.message() + ")");
  const std::string base = "out/" + fs::path(stem).filename().string();  // of an opened file's path, too
  std::string name = base + extension;
  for (int i = 2; fs::exists(name, error); ++i) name = base + "-" + std::to_string(i) + extension;
  return name;
}

GrowingFile::GrowingFile(std::string path) : path_(std::move(path)), written_(path_) {
  expect_writable(path_);
  if (fs::exists(path_) && !is_device(path_)) written_ += ".part";
  file_ = open(written_.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0666);
  if (file_ < 0) throw Error(path_, "cannot be written (" + why() + ")");
}

GrowingFile::~GrowingFile() {
  if (file_ < 0) return;
  close(file_);
  if (written_ != path_) std::remove(written_.c_str());
}

void GrowingFile::fail() {
  const std::string reason = why();
  const bool kept = written_ == path_ && ftruncate(file_, size_) == 0;
  throw Error(path_, "cannot be written any further (" + reason + "); " +
                         (kept ? "it holds what came before" : "what was there before stays"));
}

void GrowingFile::append(std::span<const std::byte> bytes) {
  if (!write_all(file_, bytes)) fail();
  size_ += std::int64_t(bytes.size());
}

void GrowingFile::append(std::string_view text) { append(std::as_bytes(std::span(text.data(), text.size()))); }

void GrowingFile::finish(std::span<const std::byte> head) {
  if (!head.empty() && pwrite(file_, head.data(), head.size(), 0) != ssize_t(head.size())) fail();
  if (written_ != path_ && std::rename(written_.c_str(), path_.c_str()) != 0) fail();
  const int file = std::exchange(file_, -1);
  if (close(file) != 0) throw Error(path_, "cannot be written whole (" + why() + ")");
}

}
