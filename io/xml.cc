#include "io/xml.h"

#include <algorithm>

namespace sudar::inline SUDAR_PRECISION::io {

namespace {

bool is_space(char c) { return c == ' ' || c == '\t' || c == '\n' || c == '\r'; }
bool begins_name(char c) {
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_' || c == ':' || (c & '\x80') != 0;
}
bool in_name(char c) { return begins_name(c) || (c >= '0' && c <= '9') || c == '-' || c == '.'; }

void append_utf8(std::string& to, std::uint32_t code) {
  const auto tail = [&](int shift) { to += char(0x80 | (code >> shift & 0x3f)); };
  if (code < 0x80) {
    to += char(code);
  } else if (code < 0x800) {
    to += char(0xc0 | code >> 6), tail(0);
  } else if (code < 0x10000) {
    to += char(0xe0 | code >> 12), tail(6), tail(0);
  } else {
    to += char(0xf0 | code >> 18), tail(12), tail(6), tail(0);
  }
}

class XmlReader {
 public:
  XmlReader(Source& source, std::string_view text, const std::string& file)
      : source_(source), text_(text), file_(file) {}

  XmlElement document() {
    if (text_.starts_with("\xff\xfe") || text_.starts_with("\xfe\xff")) fail("is UTF-16; UTF-8 is read");
    if (text_.find('\0') != std::string_view::npos) fail("is no text: it contains a zero byte");
    skip("\xef\xbb\xbf");
    pass_over();
    if (rest().empty()) fail("has no element");
    if (rest()[0] != '<') fail("is no XML: an element was expected");
    XmlElement root = element(1);
    pass_over();
    if (!rest().empty()) fail("something follows the end of the root element");
    return root;
  }

 private:
  [[noreturn]] void fail(const std::string& reason) const { throw FileError({file_, line_, {}}, reason); }

  std::string_view rest() const { return text_.substr(position_); }
  void advance(std::size_t n) {
    line_ +=
        int(std::count(text_.begin() + std::ptrdiff_t(position_), text_.begin() + std::ptrdiff_t(position_ + n), '\n'));
    position_ += n;
  }
  bool skip(std::string_view what) {
    if (!rest().starts_with(what)) return false;
    advance(what.size());
    return true;
  }
  void skip_spaces() {
    std::size_t n = 0;
    while (n < rest().size() && is_space(rest()[n])) ++n;
    advance(n);
  }
  std::string_view up_to(std::string_view end, const char* what) {
    const std::size_t n = rest().find(end);
    if (n == std::string_view::npos) fail(std::string(what) + " never ends");
    const std::string_view inside = rest().substr(0, n);
    advance(n + end.size());
    return inside;
  }

  // One comment, instruction or document type; false: none is here.
  bool aside() {
    if (skip("<!--")) {
      up_to("-->", "a comment");
    } else if (skip("<?")) {
      up_to("?>", "an instruction");
    } else if (skip("<!DOCTYPE")) {
      if (up_to(">", "a document type").find('[') != std::string_view::npos)
        fail("declares entities or elements of its own, which are not read");
    } else {
      return false;
    }
    return true;
  }
  // Spaces, comments, instructions, before and after the root.
  void pass_over() {
    do skip_spaces();
    while (aside());
  }

  std::string name(const char* of) {
    std::size_t n = 0;
    if (!rest().empty() && begins_name(rest()[0])) {
      while (n < rest().size() && in_name(rest()[n])) ++n;
    }
    if (n == 0) fail(std::string("the name of ") + of + " was expected");
    if (n > longest_name) fail(std::string("the name of ") + of + " is too long");
    std::string result(rest().substr(0, n));
    advance(n);
    return result;
  }

  // &lt; and the like, after the ampersand.
  void entity(std::string& to) {
    constexpr std::pair<std::string_view, char> known[] = {
        {"lt;", '<'}, {"gt;", '>'}, {"amp;", '&'}, {"quot;", '"'}, {"apos;", '\''}};
    for (const auto& [text, character] : known) {
      if (!skip(text)) continue;
      to += character;
      return;
    }
    if (!skip("#")) fail("an entity is not known");
    const bool hexadecimal = skip("x");
    const std::uint32_t base = hexadecimal ? 16 : 10;
    std::uint32_t code = 0;
    for (const char c : up_to(";", "a character's number")) {
      const int digit = c >= '0' && c <= '9'   ? c - '0'
                        : c >= 'a' && c <= 'f' ? c - 'a' + 10
                        : c >= 'A' && c <= 'F' ? c - 'A' + 10
                                               : 99;
      if (std::uint32_t(digit) >= base || code > 0x10ffff) fail("a character's number is wrong");
      code = code * base + std::uint32_t(digit);
    }
    if (code == 0 || code > 0x10ffff || (code >= 0xd800 && code < 0xe000)) fail("a character's number is wrong");
    append_utf8(to, code);
  }

  std::string value() {
    const char quote = rest().empty() ? '\0' : rest()[0];
    if (quote != '"' && quote != '\'') fail("an attribute's value in quotes was expected");
    advance(1);
    std::string result;
    while (true) {
      const std::size_t n = rest().find_first_of(quote == '"' ? "\"<&" : "'<&");
      if (n == std::string_view::npos) fail("an attribute's value never ends");
      result += rest().substr(0, n);
      advance(n);
      const char c = rest()[0];
      if (c == '<') fail("an attribute's value contains \"<\"");
      advance(1);
      if (c == quote) return result;
      entity(result);
    }
  }

  // The one that begins here.
  XmlElement element(std::size_t depth) {
    if (depth > source_.options().limits.nesting)
      fail("elements lie deeper in each other than " + std::to_string(source_.options().limits.nesting));
    XmlElement e;
    e.at = {file_, line_, {}};
    skip("<");
    e.name = name("an element");
    e.at.field = e.name;
    while (true) {
      const std::size_t before = position_;
      skip_spaces();
      if (rest().starts_with("/>") || rest().starts_with(">")) break;
      if (position_ == before) fail("a space, \">\" or \"/>\" was expected in " + in_quotes(e.name));
      XmlAttribute a{.at = {file_, line_, {}}};
      a.name = name("an attribute");
      a.at.field = e.name + " " + a.name;
      if (e.find(a.name) != nullptr) fail(in_quotes(e.name) + " has " + in_quotes(a.name) + " twice");
      skip_spaces();
      if (!skip("=")) fail("\"=\" was expected after " + in_quotes(a.name));
      skip_spaces();
      a.value = value();
      e.attributes.push_back(std::move(a));
      if (e.attributes.size() > most_attributes) fail(in_quotes(e.name) + " has too many attributes");
      constexpr std::size_t of_an_item = 4;  // that one has on the whole, at most
      if (++attributes_ > of_an_item * source_.options().limits.items) fail("there are too many attributes");
    }
    if (const XmlAttribute* own = e.find("name")) call(e, in_quotes(own->value));
    if (skip("/>")) return e;
    skip(">");
    children(e, depth);
    return e;
  }

  static void call(XmlElement& e, const std::string& own) {
    e.at.field = e.name + " " + own;
    for (XmlAttribute& a : e.attributes) a.at.field = e.at.field + " " + a.name;
  }

  void children(XmlElement& e, std::size_t depth) {
    while (true) {
      const std::size_t n = rest().find('<');
      if (n == std::string_view::npos)
        fail(in_quotes(e.name) + " of line " + std::to_string(e.at.line) + " never ends");
      advance(n);
      if (skip("<![CDATA[")) {
        up_to("]]>", "a text");
      } else if (skip("</")) {
        if (name("an element") != e.name)
          fail(in_quotes(e.name) + " of line " + std::to_string(e.at.line) + " should end here");
        skip_spaces();
        if (!skip(">")) fail("\">\" was expected");
        return;
      } else if (!aside()) {
        source_.count_item();
        e.children.push_back(element(depth + 1));
      }
    }
  }

  static constexpr std::size_t longest_name = 1000, most_attributes = 1000;
  Source& source_;
  std::string_view text_;
  std::string file_;
  std::size_t position_ = 0, attributes_ = 0;
  int line_ = 1;
};

}

std::string in_quotes(std::string_view text) {
  constexpr std::size_t longest = 60;
  std::string result = "\"";
  return result.append(text.substr(0, longest)).append(text.size() > longest ? "…\"" : "\"");
}

const XmlAttribute* XmlElement::find(std::string_view attribute) const {
  const auto it =
      std::find_if(attributes.begin(), attributes.end(), [&](const auto& a) { return a.name == attribute; });
  return it == attributes.end() ? nullptr : &*it;
}

const XmlElement* XmlElement::child(std::string_view element) const {
  const auto it = std::find_if(children.begin(), children.end(), [&](const auto& e) { return e.name == element; });
  return it == children.end() ? nullptr : &*it;
}

XmlElement parse_xml(Source& source, std::string_view text, const std::string& file) {
  return XmlReader(source, text, file).document();
}

}
