#include "view/png.h"

#include <png.h>

#include <cstdio>
#include <memory>
#include <stdexcept>

namespace sudar::view {

namespace {

struct Close {
  void operator()(std::FILE* f) const { std::fclose(f); }
};
using File = std::unique_ptr<std::FILE, Close>;

// libpng reports errors through a callback that must not return. The exception passes through libpng's frames, which
// hold nothing that needs unwinding: the structures are freed by the guards below.
[[noreturn]] void on_error(png_structp png, png_const_charp message) {
  const auto* path = static_cast<const std::string*>(png_get_error_ptr(png));
  throw std::runtime_error(*path + ": " + message);
}
void on_warning(png_structp, png_const_charp) {}

struct Writer {
  png_structp png;
  png_infop info;
  explicit Writer(std::string& path)
      : png(png_create_write_struct(PNG_LIBPNG_VER_STRING, &path, on_error, on_warning)),
        info(png_create_info_struct(png)) {}
  ~Writer() { png_destroy_write_struct(&png, &info); }
};
struct Reader {
  png_structp png;
  png_infop info;
  explicit Reader(std::string& path)
      : png(png_create_read_struct(PNG_LIBPNG_VER_STRING, &path, on_error, on_warning)),
        info(png_create_info_struct(png)) {}
  ~Reader() { png_destroy_read_struct(&png, &info, nullptr); }
};

void write_open_file(std::FILE* file, std::string path, const Image& image, const PngText& text) {
  Writer w(path);
  png_init_io(w.png, file);
  png_set_IHDR(w.png, w.info, png_uint_32(image.width), png_uint_32(image.height), 8, PNG_COLOR_TYPE_RGBA,
               PNG_INTERLACE_NONE, PNG_COMPRESSION_TYPE_DEFAULT, PNG_FILTER_TYPE_DEFAULT);
  png_set_sRGB(w.png, w.info, PNG_sRGB_INTENT_PERCEPTUAL);
  PngText copy = text;  // libpng wants writable strings
  std::vector<png_text> chunks;
  for (auto& [key, value] : copy) {
    png_text chunk{};
    chunk.compression = PNG_TEXT_COMPRESSION_NONE;
    chunk.key = key.data();
    chunk.text = value.data();
    chunk.text_length = value.size();
    chunks.push_back(chunk);
  }
  png_set_text(w.png, w.info, chunks.data(), int(chunks.size()));
  png_write_info(w.png, w.info);
  const std::size_t row = std::size_t(4) * std::size_t(image.width);
  for (int y = 0; y < image.height; ++y) png_write_row(w.png, &image.rgba[row * std::size_t(y)]);
  png_write_end(w.png, w.info);
}

}

void write_png(const std::string& path, const Image& image, const PngText& text) {
  const std::string partial = path + ".part";
  try {
    File file(std::fopen(partial.c_str(), "wb"));
    if (!file) throw std::runtime_error(path + ": cannot be written");
    write_open_file(file.get(), path, image, text);
    if (std::fflush(file.get()) != 0) throw std::runtime_error(path + ": cannot be written whole (disk full?)");
    file.reset();
    if (std::rename(partial.c_str(), path.c_str()) != 0) throw std::runtime_error(path + ": cannot be written");
  } catch (...) {
    std::remove(partial.c_str());
    throw;
  }
}

Image read_png(const std::string& path, PngText* text) {
  File file(std::fopen(path.c_str(), "rb"));
  if (!file) throw std::runtime_error(path + ": cannot be read");
  std::string name = path;
  Reader r(name);
  png_init_io(r.png, file.get());
  png_read_info(r.png, r.info);
  png_set_expand(r.png);
  png_set_strip_16(r.png);
  png_set_gray_to_rgb(r.png);
  png_set_add_alpha(r.png, 255, PNG_FILLER_AFTER);
  png_read_update_info(r.png, r.info);
  Image image{int(png_get_image_width(r.png, r.info)), int(png_get_image_height(r.png, r.info)), {}};
  const std::size_t row = png_get_rowbytes(r.png, r.info);
  image.rgba.resize(row * std::size_t(image.height));
  for (int y = 0; y < image.height; ++y) png_read_row(r.png, &image.rgba[row * std::size_t(y)], nullptr);
  png_read_end(r.png, r.info);
  if (text) {
    png_textp chunks = nullptr;
    const int count = png_get_text(r.png, r.info, &chunks, nullptr);
    for (int i = 0; i < count; ++i) text->emplace_back(chunks[i].key, chunks[i].text);
  }
  return image;
}

}
