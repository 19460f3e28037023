#pragma once

#include "page/Page.h"

#include <insonate/curriculum/Person.h>

#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <string>
#include <vector>

namespace insonate::web {

/// Content of class pages in memory, so that the open pages of a class, which all ask after a change, share one reading
/// of the database. A content is used again for a minute at most, since attention and lapses depend on the time, and
/// only while the database has no change that concerns the class, made by any program. The permission of each user is
/// checked, and the access is logged, as if the user had read the data. Keeps a limited number of classes. For any
/// thread.
class ClassContents {
 public:
  struct Content {
    Markup sections{};
    std::vector<Person> people{};  ///< members when the content was read, sorted by id
  };
  /// Reads the content of a class with the permissions of the user of the visit.
  using Read = std::function<Result<Content>()>;
  struct Shown {
    Markup sections{};
    std::int64_t number = -1;  ///< LiveUpdates::numberOfLastChange() before the content was read or compared
  };

  /// Returns the content of a class for the user of the visit: the stored one, or that of read(). Others who ask for
  /// the same class wait meanwhile. `cohort`: class as it is now.
  Result<Shown> show(const Visit& visit, const Cohort& cohort, const Read& read);

 private:
  struct Entry {
    std::mutex mutex{};
    Cohort cohort{};
    Content content{};
    std::int64_t number = -1;  ///< number of the last change that was compared; -1: no content
    std::int64_t read_us = 0;
    std::int64_t used_us = 0;  ///< protected by ClassContents::mutex_; the other fields by Entry::mutex
  };
  std::shared_ptr<Entry> entryOf(const std::string& cohort, std::int64_t now_us);
  static Result<bool> isCurrent(const Entry& entry, const Visit& visit, const Cohort& cohort,
                                const std::set<std::string>& changed);

  std::mutex mutex_;
  std::map<std::string, std::shared_ptr<Entry>> entries_;
};

}  // namespace insonate::web
