#include "main/files.h"

#include <cstdio>
#include <filesystem>

namespace sudar::app {

namespace {

void rename_to(const std::string& partial, const std::string& path) {
  if (std::rename(partial.c_str(), path.c_str()) == 0) return;
  std::remove(partial.c_str());
  throw Error(path, "cannot be written");
}

}

Bytes read_file(const std::string& path) {
  std::ifstream in(path, std::ios::binary | std::ios::ate);
  const std::streamoff size = in ? std::streamoff(in.tellg()) : -1;
  Bytes bytes(std::size_t(size < 0 ? 0 : size));
  in.seekg(0);
  in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(bytes.size()));
  if (!in || size < 0) throw Error(path, "cannot be read");
  return bytes;
}

void write_file(const std::string& path, std::span<const std::byte> bytes) {
  const std::string partial = path + ".part";
  std::ofstream out(partial, std::ios::binary);
  out.write(reinterpret_cast<const char*>(bytes.data()), std::streamsize(bytes.size()));
  out.close();
  if (!out) {
    std::remove(partial.c_str());
    throw Error(path, "cannot be written");
  }
  rename_to(partial, path);
}

std::string unused_name(const std::string& stem, const std::string& extension) {
  std::error_code error;
  std::filesystem::create_directories("out", error);
  if (error) throw Error("out", "the folder cannot be made (" + error.message() + ")");
  std::string name = "out/" + stem + extension;
  for (int i = 2; std::filesystem::exists(name, error); ++i) name = "out/" + stem + "-" + std::to_string(i) + extension;
  return name;
}

TextFile::TextFile(std::string path) : path_(std::move(path)), partial_(path_ + ".part"), out_(partial_) {
  if (!out_) throw Error(path_, "cannot be written");
}

TextFile::~TextFile() {
  if (out_.is_open()) out_.close(), std::remove(partial_.c_str());
}

void TextFile::commit() {
  out_.close();
  if (!out_) {
    std::remove(partial_.c_str());
    throw Error(path_, "cannot be written whole (disk full?)");
  }
  rename_to(partial_, path_);
}

}
