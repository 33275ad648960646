// Files in and out. An error names the file and says what is wrong with it.
#pragma once

#include <sudar/world.h>

#include <string>

namespace sudar::app {

Bytes read_file(const std::string& path);  // throws Error

// What `load` makes of the file's bytes; what it throws then names the file, too.
template <class F>
auto load_file(const std::string& path, F load) {
  Bytes bytes = read_file(path);
  try {
    return load(std::move(bytes));
  } catch (const Error& e) { throw Error(path, e.what()); }
}

// A file appears under its name when it is complete; if that fails, what was there before stays. Throws Error.
void write_file(const std::string& path, std::span<const std::byte>);

// Throws Error where write_file() is bound to: in no folder, or itself one. For before the work.
void expect_writable(const std::string& path);

// "out/STEM.png", or "out/STEM-2.png" and so on where that is taken; makes the folder. Throws Error.
std::string unused_name(const std::string& stem, const std::string& extension);

// A file that grows while a run goes on. What was appended is with the system at once: whatever ends the program, it is
// there. Where a file of that name was before, it stays until finish(), and the new one is called NAME.part so long.
class GrowingFile {
 public:
  explicit GrowingFile(std::string path);  // throws Error
  ~GrowingFile();                          // unfinished: a NAME.part goes; what has its name stays as it is
  GrowingFile(const GrowingFile&) = delete;
  // Throws Error where it could not be written, on a full disk say; the file then ends where the part before ended.
  void append(std::span<const std::byte>);
  void append(std::string_view);
  void finish(std::span<const std::byte> head = {});  // `head` replaces the first bytes
  const std::string& path() const { return path_; }

 private:
  [[noreturn]] void fail();
  std::string path_, written_;  // its name, and the one that it has so long
  int file_;
  std::int64_t size_ = 0;
};

}
