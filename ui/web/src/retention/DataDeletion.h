#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/ErasedAttempts.h>
#include <insonate/curriculum/Retention.h>
#include <insonate/web/WebServer.h>

#include <stop_token>
#include <thread>

namespace insonate::web {

/// Applies the rule of retention once a day, and deletes the recordings and videos of people who were erased, also by
/// other programs, within ten seconds, on a thread of its own, until it is destroyed.
class DataDeletion {
 public:
  DataDeletion(const CurriculumStore& store, const WebOptions& options);
  DataDeletion(const DataDeletion&) = delete;
  DataDeletion& operator=(const DataDeletion&) = delete;

 private:
  void run(const std::stop_token& stop);
  bool removeNew();
  bool remove(const Result<FilesToDelete>& files) const;

  const WebOptions options_;
  RetentionSchedule retention_;
  ErasedAttempts attempts_;
  std::jthread thread_;  // declared last, since the thread uses the other members
};

}  // namespace insonate::web
