#pragma once

#include <insonate/curriculum/FilledForm.h>

namespace insonate::ui {

/// Assigns ids to forms that are sent to the store. If the connection fails while a form is sent, it is unknown whether
/// the form was stored. The same answers therefore get the same id when they are sent again, so that the store
/// recognizes them.
class FormSending {
 public:
  /// Returns `filled` with an id: the previous id if the previous form has the same contents and author, else a new id.
  FilledForm identified(FilledForm filled);
  /// Call this when the store has confirmed the form. After that, the same answers get a new id.
  void stored() { last_ = {}; }

 private:
  FilledForm last_;
};

}  // namespace insonate::ui
