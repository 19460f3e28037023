#include "page/Markup.h"

#include <insonate/core/Words.h>

#include <algorithm>
#include <array>

namespace insonate::web {
namespace {

bool hasNoEnd(std::string_view tag) {
  constexpr std::array<std::string_view, 4> kEmpty{"input", "meta", "link", "br"};
  return std::ranges::find(kEmpty, tag) != kEmpty.end();
}

}  // namespace

Markup text(std::string_view plain) {
  Markup markup;
  markup.html_ = escapedMarkup(plain);
  return markup;
}

Markup element(std::string_view tag, const Attributes& attributes, const Markup& content) {
  Markup markup;
  std::string& html = markup.html_;
  html.append("<").append(tag);
  for (const auto& [name, value] : attributes)
    html.append(" ").append(name).append("=\"").append(escapedMarkup(value)).append("\"");
  html += '>';
  if (!hasNoEnd(tag)) html.append(content.html_).append("</").append(tag).append(">");
  return markup;
}

Markup element(std::string_view tag, const Attributes& attributes, std::string_view plain) {
  return element(tag, attributes, text(plain));
}

Markup link(const std::string& address, std::string_view plain) {
  return element("a", {{"href", address}}, plain);
}

Markup table(std::string_view caption, const std::vector<std::string>& titles,
             const std::vector<std::vector<Markup>>& rows) {
  Markup head, body;
  for (const std::string& title : titles) head += element("th", {{"scope", "col"}}, title);
  for (const auto& row : rows) {
    Markup cells;
    for (std::size_t i = 0; i < row.size(); ++i)
      cells += i == 0 ? element("th", {{"scope", "row"}}, row[i]) : element("td", {}, row[i]);
    body += element("tr", {}, cells);
  }
  const Markup whole =
      element("caption", {}, caption) + element("thead", {}, element("tr", {}, head)) + element("tbody", {}, body);
  // A wide table scrolls by itself, also by keyboard, instead of the page.
  return element("div",
                 {{"class", "scroll"}, {"tabindex", "0"}, {"role", "region"}, {"aria-label", std::string(caption)}},
                 element("table", {}, whole));
}

}  // namespace insonate::web
