#include "XmlElement.h"

#include <algorithm>
#include <array>
#include <cctype>

namespace insonate {
namespace {

constexpr int kMaxDepth = 8;
constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
    {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};

bool isNameCharacter(char c) {
  return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '-' || c == '.' || c == ':';
}

class XmlReader {
 public:
  explicit XmlReader(std::string_view text) : text_(text) {}

  bool document(XmlElement& element) {
    skipBetween();
    return read(element, 0) && (skipBetween(), text_.empty());
  }

 private:
  bool accept(std::string_view word) {
    if (!text_.starts_with(word)) return false;
    text_.remove_prefix(word.size());
    return true;
  }
  void skipSpace() {
    while (!text_.empty() && std::isspace(static_cast<unsigned char>(text_.front())) != 0) text_.remove_prefix(1);
  }
  /// Skips everything up to and including `end`; all the rest if there is no `end`.
  void skipPast(std::string_view end) {
    const std::size_t found = text_.find(end);
    text_.remove_prefix(found == std::string_view::npos ? text_.size() : found + end.size());
  }
  void skipBetween() {
    for (;;) {
      text_.remove_prefix(std::min(text_.find('<'), text_.size()));
      if (text_.starts_with("<!--"))
        skipPast("-->");
      else if (text_.starts_with("<?"))
        skipPast("?>");
      else
        return;
    }
  }
  bool name(std::string& into) {
    const auto end = std::ranges::find_if_not(text_, isNameCharacter);
    into.assign(text_.begin(), end);
    text_.remove_prefix(into.size());
    return !into.empty();
  }
  bool value(std::string& into) {
    if (text_.empty() || (text_.front() != '"' && text_.front() != '\'')) return false;
    const char quote = text_.front();
    text_.remove_prefix(1);
    while (!text_.empty() && text_.front() != quote) {
      if (text_.front() == '<') return false;
      if (text_.front() != '&') {
        into += text_.front();
        text_.remove_prefix(1);
        continue;
      }
      const auto entity =
          std::ranges::find_if(kEntities, [&](const auto& known) { return text_.starts_with(known.first); });
      if (entity == kEntities.end()) return false;
      into += entity->second;
      text_.remove_prefix(entity->first.size());
    }
    return accept(std::string_view(&quote, 1));
  }
  bool read(XmlElement& element, int depth) {
    if (depth > kMaxDepth || !accept("<") || !name(element.name)) return false;
    for (skipSpace(); !text_.starts_with("/") && !text_.starts_with(">"); skipSpace()) {
      auto& [key, content] = element.attributes.emplace_back();
      if (!name(key)) return false;
      skipSpace();
      if (!accept("=")) return false;
      skipSpace();
      if (!value(content)) return false;
    }
    if (accept("/>")) return true;
    if (!accept(">")) return false;
    for (skipBetween(); !text_.starts_with("</"); skipBetween())
      if (text_.empty() || !read(element.children.emplace_back(), depth + 1)) return false;
    std::string end;
    if (!accept("</") || !name(end) || end != element.name) return false;
    skipSpace();
    return accept(">");
  }

  std::string_view text_;
};

}  // namespace

std::string_view XmlElement::attribute(std::string_view attributeName) const {
  for (const auto& [key, value] : attributes)
    if (key == attributeName) return value;
  return {};
}

Result<XmlElement> parsedXml(std::string_view text) {
  XmlElement element;
  if (!XmlReader(text.substr(0, text.find('\0'))).document(element))
    return fail("The command is not an XML element, such as <Command Name=\"SetUsParameter\"/>.");
  return element;
}

std::string escapedXml(std::string_view text) {
  std::string escaped;
  for (const char c : text) {
    const auto entity = std::ranges::find_if(kEntities, [&](const auto& known) { return known.second == c; });
    if (entity != kEntities.end())
      escaped += entity->first;
    else
      escaped += c;
  }
  return escaped;
}

}  // namespace insonate
