#pragma once

#include <insonate/curriculum/FilledForm.h>

namespace insonate::ui {

/// Ids of forms on their way to the store. If the server disappears in between, nobody knows whether a form was
/// stored: the same answers, sent again, keep their id, by which the store recognizes them.
class FormSending {
 public:
  /// Returns `filled` with its id; `by` is part of its contents.
  FilledForm identified(FilledForm filled);
  /// The store has said yes. The same answers are another form from now on.
  void stored() { last_ = {}; }

 private:
  FilledForm last_;
};

}  // namespace insonate::ui
