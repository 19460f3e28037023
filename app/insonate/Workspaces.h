#pragma once

namespace insonate::ui {
class MainWindow;
}

namespace insonate::app {

/// Adds the workspaces of the program to its window: Prepare, Train and Review.
void addWorkspaces(ui::MainWindow& window);

}  // namespace insonate::app
