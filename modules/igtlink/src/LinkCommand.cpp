#include "XmlElement.h"

#include <insonate/igtlink/LinkCommand.h>

namespace insonate {

Result<LinkCommand> parsedCommand(std::string_view text) {
  const auto element = parsedXml(text);
  if (!element) return tl::unexpected(element.error());
  if (element->name != "Command" || element->attribute("Name").empty())
    return fail("The command is not an element Command with an attribute Name.");
  LinkCommand command{std::string(element->attribute("Name")), {}};
  for (const XmlElement& child : element->children)
    if (child.name == "Parameter")
      command.parameters.push_back({std::string(child.attribute("Name")), std::string(child.attribute("Value")), true});
  return command;
}

std::string replyText(const LinkReply& reply) {
  std::string text = std::string("<CommandReply Status=\"") + (reply.success ? "SUCCESS" : "FAIL") + "\" Message=\"" +
                     escapedXml(reply.sentence) + "\"";
  if (reply.parameters.empty()) return text + " />";
  text += ">";
  for (const LinkParameter& parameter : reply.parameters)
    text += "<Parameter Name=\"" + escapedXml(parameter.name) + "\" Success=\"" +
            (parameter.success ? "true" : "false") + "\" Value=\"" + escapedXml(parameter.value) + "\" />";
  return text + "</CommandReply>";
}

}  // namespace insonate
