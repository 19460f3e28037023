#pragma once

#include <insonate/curriculum/FilledForm.h>

namespace insonate::ui {

/// Ids of forms on their way to the store. Where the server goes away in between, nobody can tell whether a form was
/// stored: the same answers, sent again, keep their id, by which the store knows them.
class FormSending {
 public:
  /// `filled` with its id; `by` is part of what it says.
  FilledForm identified(FilledForm filled);
  /// The store has said yes. The same answers are another form from now on.
  void stored() { last_ = {}; }

 private:
  FilledForm last_;
};

}  // namespace insonate::ui
