#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace insonate::web {

/// A piece of HTML or SVG. Text and values of attributes can be added only through text() and element(), which escape
/// them, so that no name of a person or class can become a tag.
class Markup {
 public:
  Markup() = default;
  const std::string& html() const { return html_; }
  bool empty() const { return html_.empty(); }
  Markup& operator+=(const Markup& more) {
    html_ += more.html_;
    return *this;
  }
  friend Markup operator+(Markup first, const Markup& second) { return first += second; }

 private:
  friend Markup text(std::string_view plain);
  friend Markup element(std::string_view tag, const std::vector<std::pair<std::string_view, std::string>>& attributes,
                        const Markup& content);
  std::string html_;
};

using Attributes = std::vector<std::pair<std::string_view, std::string>>;

/// Returns a text with the characters & < > " ' escaped.
Markup text(std::string_view plain);
/// Returns <tag attributes>content</tag>; tags and names of attributes are written as they are. Elements that HTML
/// defines as empty (input, meta, link, br) get no end tag.
Markup element(std::string_view tag, const Attributes& attributes, const Markup& content);
Markup element(std::string_view tag, const Attributes& attributes, std::string_view plain = {});
Markup link(const std::string& address, std::string_view plain);

/// Returns a table with a caption that screen readers announce; each row has one cell for each title. The first cell of
/// a row is its heading.
Markup table(std::string_view caption, const std::vector<std::string>& titles,
             const std::vector<std::vector<Markup>>& rows);

}  // namespace insonate::web
