#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <span>
#include <string>

namespace insonate::cli {

/// Connection to a learning record store: a server that collects Experience API (xAPI) statements from learning
/// platforms.
struct LearningRecords {
  /// Address, e.g. "https://lrs.example.org/xapi"; http is allowed only for this computer, since passwords are sent.
  std::string endpoint;
  std::string user, password;
};

/// Sends xAPI statements, each a JSON object, to a learning record store in batches (Experience API 1.0.3, part
/// three, 2.1.2). The server recognizes a repeated statement by its id. Fails with the server's message; batches sent
/// before stay stored.
Result<void> sendStatements(const LearningRecords& records, std::span<const std::string> statements,
                            const Progress& progress);

}  // namespace insonate::cli
