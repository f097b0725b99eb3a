// SPDX-License-Identifier: MIT
// SPDX-FileCopyrightText: Romanesco authors
#pragma once

namespace romanesco {

/// How exact pictures may be while the camera moves, so that each is there in time: found from what the last took. Their
/// cost goes about with the square of the pixels to a tolerance.
class DragTolerance
{
public:
    /// In pixels: where everything is slow, where it is fast, and before anything is known.
    static constexpr double coarsest = 64.0;
    static constexpr double finest = 1.0;
    static constexpr double first = 4.0;

    /// Of one picture.
    static constexpr double budgetMilliseconds = 33.0;
    /// A picture that is not there by then is given up for a coarser one.
    static constexpr double mostMilliseconds = 2.0 * budgetMilliseconds;

    /// For the next picture.
    [[nodiscard]] double pixels() const { return m_pixels; }

    /// A picture of this tolerance was finished.
    void finished(double milliseconds);
    /// Whether a picture that has been drawn for so long is given up; then the tolerance is coarser.
    [[nodiscard]] bool givesUp(double milliseconds);

private:
    double m_pixels = first;
};

}
