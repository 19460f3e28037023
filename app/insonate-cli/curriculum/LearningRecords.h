#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <span>
#include <string>

namespace insonate::cli {

/// Connection to a learning record store, which collects records of activity from a site's learning platforms.
struct LearningRecords {
  std::string
      endpoint;  ///< "https://lrs.example.org/xapi"; without TLS on this computer only, since passwords go there
  std::string user, password;
};

/// Sends statements, each a JSON object, in batches (Experience API 1.0.3, part three, 2.1.2). A statement that is sent
/// again is stored once, since the store recognizes its id. Fails with the store's message; batches sent before the
/// failure stay stored.
Result<void> sendStatements(const LearningRecords& records, std::span<const std::string> statements,
                            const Progress& progress);

}  // namespace insonate::cli
