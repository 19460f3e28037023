#pragma once

#include <insonate/core/Result.h>
#include <insonate/curriculum/FirstPassword.h>

#include <QString>
#include <vector>

class QTextDocument;
class QWidget;

namespace insonate::ui {

/// A page to cut into strips: whom each is for, and the password. Names stand in it as they are, whatever they hold.
void fillPasswordPaper(QTextDocument& paper, const QString& cohort, const std::vector<FirstPassword>& passwords);

/// Asks for a printer. Says where the page went: to a printer, or as a file that its owner alone can read; "" where the
/// user thought better of it.
Result<QString> printPasswordPaper(const QString& cohort, const std::vector<FirstPassword>& passwords, QWidget* parent);

}  // namespace insonate::ui
