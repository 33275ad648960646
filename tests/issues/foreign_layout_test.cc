// Arrays and settings came and went, but the version of snapshots and recordings stayed 1: a file written before was
// read with its bytes taken for other fields, or refused for being "damaged". Now a file says how it is laid out, by a
// number that follows from the fields, and what has another layout is refused in words.
#include <sudar/record.h>

#include "base/file_header.h"
#include "geometry/archive.h"
#include "unit/worlds.h"

namespace sudar_test {
namespace {

enum class Colour : std::uint8_t { red, green };
inline const char* const* names(Colour) {
  static constexpr const char* n[] = {"red", "green", nullptr};
  return n;
}
enum class Swapped : std::uint8_t { green, red };
inline const char* const* names(Swapped) {
  static constexpr const char* n[] = {"green", "red", nullptr};
  return n;
}

template <class T>
std::uint64_t layout_of(const char* name, const T& example) {
  LayoutWriter w;
  w.named(name, example);
  return w.layout();
}

TEST(ForeignLayout, FollowsFromTheFields) {
  using Numbers = std::vector<float>;
  const std::uint64_t layout = layout_of("speed", Numbers{});
  EXPECT_EQ(layout_of("speed", Numbers{1, 2, 3}), layout) << "values are no layout";
  EXPECT_NE(layout_of("pace", Numbers{}), layout) << "renamed";
  EXPECT_NE(layout_of("speed", std::vector<std::int32_t>{}), layout) << "another type of the same size";
  EXPECT_NE(layout_of("speed", std::vector<double>{}), layout) << "another size";
  EXPECT_NE(layout_of("colour", Colour::red), layout_of("colour", Swapped::green))
      << "the same number, another meaning";
  EXPECT_NE(layout_of("limit", std::vector<Limit>{}), layout_of("limit", std::vector<Filter>{})) << "structs";
}

// What is there only sometimes counts, too.
TEST(ForeignLayout, CountsWhatIsNotThere) {
  EXPECT_NE(layout_of("x", std::optional<float>{}), layout_of("x", std::optional<double>{}));
  EXPECT_EQ(layout_of("x", std::optional<float>{}), layout_of("x", std::optional<float>{2.0f}));
  using One = std::variant<Bar, Rope>;
  using Other = std::variant<Bar, Ball>;
  EXPECT_NE(layout_of("x", One{}), layout_of("x", Other{}));
}

// --- files ---

constexpr std::size_t version_at = 8, writer_at = 24;

template <class Open>
Error refusal(Bytes file, std::size_t at, Open open) {
  file[at] ^= std::byte{7};
  file.resize(file.size() - 8);
  ByteWriter sealed;
  sealed.raw(file);
  try {
    open(sealed.take_sealed());
  } catch (const Error& e) { return e; }
  ADD_FAILURE() << "taken";
  return {"", ""};
}

template <class Open>
void expect_refused_in_words(const Bytes& file, Open open) {
  const std::string version = SUDAR_VERSION;
  const Error layout = refusal(file, writer_at + version.size(), open);
  EXPECT_EQ(layout.field, "layout");
  const std::string words = layout.what();
  const std::size_t first = words.find("sudar " + version);
  ASSERT_NE(first, std::string::npos) << words;
  EXPECT_NE(words.find("sudar " + version, first + 1), std::string::npos) << "both are named: " << words;
  const Error other_version = refusal(file, version_at, open);
  EXPECT_EQ(other_version.field, "version");
  EXPECT_NE(std::string(other_version.what()).find("is " + std::to_string(format_version ^ 7)), std::string::npos);
  EXPECT_NE(std::string(other_version.what()).find("reads " + std::to_string(format_version)), std::string::npos);
}

TEST(ForeignLayout, IsRefusedInWords) {
  World w(steady());
  w.add(cube({0, 0, 0}));
  expect_refused_in_words(w.save(), [](const Bytes& file) { World().load(file); });
  Recorder recorder(w, "");
  w.step(), recorder.after_step();
  expect_refused_in_words(recorder.bytes(), [](const Bytes& file) { Replay{file}; });
}

}
}
