// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

#include <functional>
#include <stop_token>
#include <string>

namespace romanesco {

/// What a trial looks at while it goes on.
struct TrialContext {
    /// Heard within some milliseconds, but where a collider is being built that does not hear it.
    std::stop_token stop = {};
    /// Told what is measured next, and the share of the whole that is done, from 0 to 1. In the thread that measures.
    std::function<void(const std::string &what, double share)> progress = {};

    [[nodiscard]] bool isStopped() const { return stop.stop_requested(); }
    void tell(const std::string &what, double share) const
    {
        if (progress) {
            progress(what, share);
        }
    }
};

}
