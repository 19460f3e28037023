#pragma once

#include <insonate/core/Result.h>

#include <string>
#include <string_view>
#include <utility>
#include <vector>

namespace insonate {

/// An element of XML with its attributes and child elements; text between the elements is left out.
struct XmlElement {
  std::string name;
  std::vector<std::pair<std::string, std::string>> attributes;
  std::vector<XmlElement> children;

  /// Returns the value of an attribute; empty if the element lacks it.
  std::string_view attribute(std::string_view attributeName) const;
};

/// Reads one element with its attributes and children. Fails with a sentence on anything else, on a document type, and
/// on elements nested deeper than eight levels.
Result<XmlElement> parsedXml(std::string_view text);

/// Returns the text with the characters replaced that have a meaning in XML.
std::string escapedXml(std::string_view text);

}  // namespace insonate
