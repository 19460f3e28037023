#pragma once

#include <insonate/core/Result.h>

namespace insonate::store {

/// Tells the DatabaseFailures of the calling thread, if there are any, that a request to the database failed.
void noteDatabaseFailure(const Error& error);

}  // namespace insonate::store
