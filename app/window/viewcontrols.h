// SPDX-License-Identifier: GPL-3.0-or-later
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

namespace romanesco {

class ViewportPane;
struct WindowActions;

/// Lets the actions of the View menu that need no text do what they say. Both must live as long.
void connectViewControls(const WindowActions &actions, ViewportPane &pane);

}
