#include "io/source.h"

#include <algorithm>
#include <fstream>
#include <utility>

namespace sudar::inline SUDAR_PRECISION::io {

namespace fs = std::filesystem;

namespace {

// Both canonical. Component by component: /a/bc does not lie in /a/b.
bool lies_in(const fs::path& file, const fs::path& folder) {
  return std::mismatch(folder.begin(), folder.end(), file.begin(), file.end()).first == folder.end();
}

fs::path canonical_folder(const fs::path& folder) {
  std::error_code error;
  const fs::path result = fs::canonical(folder.empty() ? fs::path(".") : folder, error);
  if (error || !fs::is_directory(result, error)) throw Error(folder.string(), "there is no such folder");
  return result;
}

}

Source::Source(const fs::path& file, const ReadOptions& options) : file_(file), options_(options) {
  std::error_code error;
  if (!fs::exists(file, error)) throw Error("", "there is no such file");
  folders_.push_back(canonical_folder(file.parent_path()));
  for (const fs::path& folder : options.allow) folders_.push_back(canonical_folder(folder));
  bytes_ = read(file);
}

fs::path Source::find(const std::string& name, const fs::path& from) const {
  if (name.empty() || name.find('\0') != std::string::npos) throw Error("", "names no file");
  const fs::path path = (from.empty() ? file_ : from).parent_path() / name;
  std::error_code error;
  const fs::path real = fs::canonical(path, error);
  // Told apart only inside: a file must not find out what there is elsewhere.
  const bool inside = std::any_of(folders_.begin(), folders_.end(), [&](const fs::path& folder) {
    return lies_in(error ? fs::weakly_canonical(path.lexically_normal(), error) : real, folder);
  });
  if (!inside) {
    throw Error("", "\"" + name + "\" lies outside the folder of the file; --allow FOLDER lets it be read");
  }
  if (real.empty()) throw Error("", "there is no file \"" + name + "\"");
  return path;
}

Bytes Source::read(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) throw Error("", "\"" + path.string() + "\" is no regular file");
  const std::uintmax_t size = fs::file_size(path, error);
  if (error) throw Error("", "\"" + path.string() + "\" cannot be read (" + error.message() + ")");
  if (size > options_.limits.bytes - bytes_read_) {
    throw Error("", "\"" + path.string() + "\" is too large: more than " + std::to_string(options_.limits.bytes) +
                        " bytes would be read in all");
  }
  bytes_read_ += size;
  Bytes bytes(size);
  std::ifstream in(path, std::ios::binary);
  if (!in.read(reinterpret_cast<char*>(bytes.data()), std::streamsize(size)) && size > 0) {
    throw Error("", "\"" + path.string() + "\" cannot be read");
  }
  return bytes;
}

void Source::add(Severity severity, Origin at, std::string message) {
  if (at.file.empty()) at.file = file_.string();
  // Of errors the first is always kept: it is the reason.
  const bool kept = findings_.size() < options_.limits.findings || (severity == Severity::error && !refused_);
  refused_ = refused_ || severity == Severity::error;
  if (!kept && std::exchange(overflown_, true)) return;
  if (!kept) severity = Severity::note, at.line = 0, at.field.clear(), message = "there is more, which is not listed";
  findings_.push_back({severity, std::move(at), std::move(message)});
}

void Source::count(std::size_t& sum, std::size_t more, std::size_t most, const char* what) {
  if (more > most - sum) throw Error("", "has more than " + std::to_string(most) + " " + what);
  sum += more;
}

}
