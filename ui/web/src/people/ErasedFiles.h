#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/ErasedAttempts.h>
#include <insonate/web/WebServer.h>

#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace insonate::web {

/// Deletes the recordings and videos of people who were erased, also by other programs, within ten seconds, on a thread
/// of its own, until it is destroyed.
class ErasedFiles {
 public:
  ErasedFiles(const CurriculumStore& store, const WebOptions& options);
  ~ErasedFiles();
  ErasedFiles(const ErasedFiles&) = delete;
  ErasedFiles& operator=(const ErasedFiles&) = delete;

 private:
  void run();
  Result<void> removeNew();

  const WebOptions options_;
  ErasedAttempts attempts_;
  std::mutex mutex_;
  std::condition_variable wake_;
  bool isEnding_ = false;
  std::thread thread_;
};

}  // namespace insonate::web
