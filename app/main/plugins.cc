#include "main/plugins.h"

#include <dlfcn.h>
#include <elf.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <fstream>

#ifdef SUDAR_STATIC_SCENARIOS
#include "scenarios/linked.h"
#endif

namespace sudar::app {

void Plugins::Close::operator()(void* library) const { dlclose(library); }

#ifdef SUDAR_STATIC_SCENARIOS

Plugins::Plugins(const std::string& folder) {
  if (!folder.empty()) throw Error("--scenarios", "this program has its scenarios linked in and loads no others");
  for (const ScenarioEntry* entry : linked_scenarios()) catalogue_.add(entry);
}

#else

namespace {

namespace fs = std::filesystem;

fs::path usual_folder() {
  if (const char* set = std::getenv("SUDAR_SCENARIOS"); set && *set) return set;
  return fs::read_symlink("/proc/self/exe").parent_path() / SUDAR_SCENARIOS_FROM_PROGRAM;
}

// Sorted, so that of two plugins of one name always the same is refused.
std::vector<fs::path> libraries_in(const fs::path& folder) {
  std::vector<fs::path> found;
  std::error_code error;
  for (const fs::directory_entry& entry : fs::directory_iterator(folder, error)) {
    if (entry.path().extension() == ".so") found.push_back(entry.path());
  }
  if (error) throw Error(folder.string(), "the folder of the scenarios cannot be read (" + error.message() + ")");
  std::sort(found.begin(), found.end());
  return found;
}

// Why the file cannot be a shared library of this machine; empty: it may be one. The loader maps what the headers
// promise, and touching what the file does not hold is a SIGBUS (System V ABI, "Program Header").
std::string why_no_library(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return "it is no regular file";
  const std::uint64_t size = fs::file_size(path, error);
  std::ifstream in(path, std::ios::binary);
  Elf64_Ehdr head{}, own{};
  if (error || !in) return "it cannot be read";
  if (!in.read(reinterpret_cast<char*>(&head), sizeof head)) return "it is shorter than a library's header";
  std::ifstream("/proc/self/exe", std::ios::binary).read(reinterpret_cast<char*>(&own), sizeof own);
  if (std::memcmp(head.e_ident, own.e_ident, EI_VERSION + 1) != 0) return "it is no library for this machine";
  if (head.e_machine != own.e_machine || head.e_type != ET_DYN) return "it is no library for this machine";
  const auto within = [&](std::uint64_t from, std::uint64_t length) { return from <= size && length <= size - from; };
  if (head.e_phentsize != sizeof(Elf64_Phdr) || head.e_phnum == 0) return "its header is damaged";
  if (!within(head.e_phoff, std::uint64_t(head.e_phnum) * sizeof(Elf64_Phdr)) ||
      !within(head.e_shoff, std::uint64_t(head.e_shnum) * head.e_shentsize)) {
    return "it is cut short";
  }
  in.seekg(std::streamoff(head.e_phoff));
  for (int i = 0; i < head.e_phnum; ++i) {
    Elf64_Phdr part{};
    if (!in.read(reinterpret_cast<char*>(&part), sizeof part)) return "it cannot be read";
    if (part.p_type == PT_LOAD && !within(part.p_offset, part.p_filesz)) return "it is cut short";
  }
  return {};
}

}

Plugins::Plugins(const std::string& folder) {
  using EntryPoint = const ScenarioEntry* (*)();
  for (const fs::path& path : libraries_in(folder.empty() ? usual_folder() : fs::path(folder))) {
    const auto refuse = [&](const std::string& reason) {
      refused_.push_back("scenario plugin " + path.filename().string() + " refused: " + reason);
    };
    if (const std::string reason = why_no_library(path); !reason.empty()) {
      refuse(reason);
      continue;
    }
    std::unique_ptr<void, Close> library(dlopen(path.c_str(), RTLD_NOW | RTLD_LOCAL));
    if (!library) {
      refuse(dlerror());
      continue;
    }
    const auto entry_point = reinterpret_cast<EntryPoint>(dlsym(library.get(), "sudar_scenario"));
    if (!entry_point) {
      refuse("it has no function sudar_scenario; does its file end with SUDAR_SCENARIO(…)?");
      continue;
    }
    try {
      catalogue_.add(entry_point());
      libraries_.push_back(std::move(library));
    } catch (const std::exception& e) { refuse(e.what()); }
  }
}

#endif

}
