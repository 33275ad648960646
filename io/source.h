// The file that is being read, and what may be asked of it: its bytes, other files that it names, and a place for what
// is found. Every reader gets one.
#pragma once

#include <sudar/io.h>

namespace sudar::inline SUDAR_PRECISION::io {

class Source {
 public:
  // Throws Error where the file cannot be read.
  Source(const std::filesystem::path& file, const ReadOptions&);

  const std::filesystem::path& file() const { return file_; }
  const Bytes& bytes() const { return bytes_; }
  std::string_view text() const { return {reinterpret_cast<const char*>(bytes_.data()), bytes_.size()}; }
  const ReadOptions& options() const { return options_; }

  // The path of another file that this one names, from the folder of `from` (this file, where it is empty). Throws
  // Error where it is not there, or lies where nothing may be read from.
  std::filesystem::path find(const std::string& name, const std::filesystem::path& from = {}) const;
  // Its bytes. Throws Error, also when all files together become too large.
  Bytes read(const std::filesystem::path&);

  void note(Origin at, std::string message) { add(Severity::note, std::move(at), std::move(message)); }
  void warn(Origin at, std::string message) { add(Severity::warning, std::move(at), std::move(message)); }
  void refuse(Origin at, std::string message) { add(Severity::error, std::move(at), std::move(message)); }
  bool refused() const { return refused_; }
  std::vector<Finding> take_findings() { return std::move(findings_); }

  // Counts what a file makes, and throws Error where there is more of it than Limits allow.
  void count_item() { count(items_, 1, options_.limits.items, "bodies, shapes and joints"); }
  void count_vertices(std::size_t n) { count(vertices_, n, options_.limits.vertices, "vertices"); }
  void count_triangles(std::size_t n) { count(triangles_, n, options_.limits.vertices, "triangles"); }

 private:
  void add(Severity, Origin, std::string message);
  static void count(std::size_t& sum, std::size_t more, std::size_t most, const char* what);

  std::filesystem::path file_;
  ReadOptions options_;
  std::vector<std::filesystem::path> folders_;  // canonical: what may be read lies in one of them
  Bytes bytes_;
  std::size_t bytes_read_ = 0, items_ = 0, vertices_ = 0, triangles_ = 0;
  std::vector<Finding> findings_;
  bool refused_ = false, overflown_ = false;
};

}
