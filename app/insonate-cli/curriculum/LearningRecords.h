#pragma once

#include <insonate/core/Progress.h>
#include <insonate/core/Result.h>

#include <span>
#include <string>

namespace insonate::cli {

/// A learning record store: where learning platforms of a site collect what people did.
struct LearningRecords {
  std::string
      endpoint;  ///< "https://lrs.example.org/xapi"; without TLS on this computer only, since passwords go there
  std::string user, password;
};

/// Sends statements, each a JSON object, in batches (Experience API 1.0.3, part three, 2.1.2). They are kept once
/// however often they are sent, since each has its id. Fails with what the store said; what was sent before stays.
Result<void> sendStatements(const LearningRecords& records, std::span<const std::string> statements,
                            const Progress& progress);

}  // namespace insonate::cli
