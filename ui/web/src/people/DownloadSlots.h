#pragma once

#include <insonate/core/Result.h>

#include <memory>
#include <string>

namespace insonate::web {

/// Limits the downloads of personal data, each of which occupies the disk until its client has received it. May be used
/// on any thread.
class DownloadSlots {
 public:
  static constexpr std::size_t kMost = 3;  ///< on this server

  DownloadSlots();

  /// Reserves a download of the data of a person (Person::id), until the returned object is destroyed, which may be
  /// after this one. Fails with a sentence for the user if the person's data are being downloaded, or if there are too
  /// many downloads.
  Result<std::shared_ptr<const void>> take(const std::string& person);

 private:
  struct Taken;
  const std::shared_ptr<Taken> taken_;
};

}  // namespace insonate::web
