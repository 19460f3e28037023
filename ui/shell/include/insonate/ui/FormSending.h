#pragma once

#include <insonate/curriculum/FilledForm.h>

namespace insonate::ui {

/// Remembers the id of the form that is being sent to the store. If the connection fails, it is unknown whether the
/// form was stored. The same answers, sent again, therefore keep their id, by which the store recognizes them.
class FormSending {
 public:
  /// Returns `filled` with its id; `by` is part of its contents.
  FilledForm identified(FilledForm filled);
  /// Called when the store has confirmed the form. The same answers get a new id from then on.
  void stored() { last_ = {}; }

 private:
  FilledForm last_;
};

}  // namespace insonate::ui
