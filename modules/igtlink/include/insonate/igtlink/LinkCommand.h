#pragma once

#include <insonate/core/Result.h>

#include <string>
#include <string_view>
#include <vector>

namespace insonate {

/// A setting that a command sets or asks for.
struct LinkParameter {
  std::string name, value;
  bool success = true;  ///< in replies: false if the setting could not be set or read
};

/// A command of another program: the text of a STRING message with the device name "CMD_" and an identifier, in the
/// form of PLUS: <Command Name="SetUsParameter"><Parameter Name="DepthMm" Value="50"/></Command>
struct LinkCommand {
  std::string name;  ///< e.g. "SetUsParameter"
  std::vector<LinkParameter> parameters;
};

/// Reply to a command. The text is sent in a STRING message with the device name "ACK_" and the identifier of the
/// command.
struct LinkReply {
  bool success = false;
  std::string sentence;                   ///< result, or the reason for the failure
  std::vector<LinkParameter> parameters;  ///< settings with their present values
};

/// Reads the text of a command. Fails with a sentence.
Result<LinkCommand> parsedCommand(std::string_view text);
/// Returns the text of a reply: an element CommandReply with Status (SUCCESS or FAIL), Message, and one child Parameter
/// with Name, Success and Value for each setting.
std::string replyText(const LinkReply& reply);

}  // namespace insonate
