#pragma once

#include "../feature/Feature.h"

namespace insonate::review {

class AttemptPage;

/// Requests the case of the open attempt from the window, and states what is wrong with the recording and the case.
class CaseFeature final : public Feature {
 public:
  CaseFeature(const ReviewModel& model, AttemptPage& page);

 private:
  void findCase();
  void openKeptVersion();
  void showNotice();

  AttemptPage& page_;
  bool keptRequested_ = false;  ///< true: the case version on which this attempt was made has been requested
};

}  // namespace insonate::review
