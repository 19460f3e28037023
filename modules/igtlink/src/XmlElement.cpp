#include "XmlElement.h"

#include <expat.h>

#include <algorithm>
#include <array>
#include <memory>

namespace insonate {
namespace {

constexpr std::size_t kMaxDepth = 8;
constexpr std::array<std::pair<std::string_view, char>, 5> kEntities{
    {{"&amp;", '&'}, {"&lt;", '<'}, {"&gt;", '>'}, {"&quot;", '"'}, {"&apos;", '\''}}};

/// Builds the tree of elements from the calls of expat.
struct TreeBuilder {
  XML_Parser parser = nullptr;
  XmlElement root;
  /// Elements that are open. The children of an element grow only while no child of it is open, so that the pointers
  /// stay valid.
  std::vector<XmlElement*> open;

  static void begin(void* data, const char* name, const char** attributes) {
    auto& tree = *static_cast<TreeBuilder*>(data);
    if (tree.open.size() > kMaxDepth) return void(XML_StopParser(tree.parser, XML_FALSE));
    XmlElement& element = tree.open.empty() ? tree.root : tree.open.back()->children.emplace_back();
    element.name = name;
    for (; *attributes; attributes += 2) element.attributes.emplace_back(attributes[0], attributes[1]);
    tree.open.push_back(&element);
  }
  static void end(void* data, const char*) { static_cast<TreeBuilder*>(data)->open.pop_back(); }
  static void refuse(void* data, const char*, const char*, const char*, int) {
    XML_StopParser(static_cast<TreeBuilder*>(data)->parser, XML_FALSE);
  }
};

}  // namespace

std::string_view XmlElement::attribute(std::string_view attributeName) const {
  for (const auto& [key, value] : attributes)
    if (key == attributeName) return value;
  return {};
}

Result<XmlElement> parsedXml(std::string_view text) {
  text = text.substr(0, text.find('\0'));
  const std::unique_ptr<XML_ParserStruct, void (*)(XML_Parser)> parser(XML_ParserCreate(nullptr), XML_ParserFree);
  TreeBuilder tree{.parser = parser.get(), .root = {}, .open = {}};
  XML_SetUserData(parser.get(), &tree);
  XML_SetElementHandler(parser.get(), TreeBuilder::begin, TreeBuilder::end);
  XML_SetStartDoctypeDeclHandler(parser.get(), TreeBuilder::refuse);
  if (XML_Parse(parser.get(), text.data(), static_cast<int>(text.size()), XML_TRUE) != XML_STATUS_OK)
    return fail("The command is not an XML element, such as <Command Name=\"SetUsParameter\"/>.");
  return std::move(tree.root);
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
