// Whole files in and out. Nothing is ever left half written: a file appears under its name when it is complete.
#pragma once

#include <sudar/world.h>

#include <fstream>
#include <string>

namespace sudar::app {

Bytes read_file(const std::string& path);  // throws Error naming the file
void write_file(const std::string& path, std::span<const std::byte>);

// "out/STEM.png", or "out/STEM-2.png" and so on where that is taken; makes the folder. Throws Error.
std::string unused_name(const std::string& stem, const std::string& extension);

// A text file written piece by piece: under another name until commit(), gone if that never comes.
class TextFile {
 public:
  explicit TextFile(std::string path);
  ~TextFile();
  TextFile(const TextFile&) = delete;
  std::ostream& out() { return out_; }
  void commit();

 private:
  std::string path_, partial_;
  std::ofstream out_;
};

}
