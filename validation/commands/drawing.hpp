// SPDX-License-Identifier: BSD-3-Clause
// Line drawings in metres, as SVG and, by gnuplot, as PNG.
#pragma once

#include <filesystem>
#include <string>
#include <vector>

#include "solver/core/vec2.hpp"
#include "solver/setup/body_outline.hpp"

namespace wetdeck {

/// How an edge is drawn; no colour: not at all.
struct Stroke {
    const char* colour = "";
    double width = 1;  ///< [px]
    bool dashed = false;
};

enum class Anchor { start, middle, end };

/// How a text is drawn.
struct TextStyle {
    Anchor anchor = Anchor::start;
    double size = 13;  ///< [px]
    const char* colour = "#000000";
};

/// A drawing that grows: each call adds to both renderings. Texts are placed in pixels, y down.
class Drawing {
  public:
    /// @param area     that is drawn, without the texts around it [m]
    /// @param name     what the drawing is, for readers of the screen
    /// @param largest  width and height of the area [px]
    Drawing(const Box& area, std::string name, Vec2 largest);

    double x(double metres) const { return (metres - area_.low.x()) * scale_; }   ///< [px]
    double y(double metres) const { return (area_.high.y() - metres) * scale_; }  ///< [px]
    double width() const { return x(area_.high.x()); }                            ///< of the area [px]
    double height() const { return y(area_.low.y()); }                            ///< of the area [px]

    void polygon(const Outline& corners, const char* fill, const Stroke& edge = {});
    void line(Vec2 a, Vec2 b, const Stroke& stroke);
    /// An arrow of a given length in pixels from a point of the scene.
    void arrow(Vec2 from, Vec2 direction, double length, const char* colour);
    void label(double px, double py, const std::string& text, const TextStyle& style = {});
    /// A numbered mark at a place in pixels.
    void mark(double px, double py, std::size_t number);
    /// Says where the last line of text is [px].
    void end_at(double py) { end_ = py; }

    std::string svg() const;
    /// Draws to a file whose name ends in .png or .svg. Throws InputError for another ending and
    /// EnvironmentError where gnuplot fails.
    void write(const std::filesystem::path& file) const;

  private:
    void line_px(Vec2 a, Vec2 b, const Stroke& stroke);

    Box area_;
    std::string name_;
    double scale_, end_ = 0;
    std::string svg_, gnuplot_;
    int objects_ = 0;
};

}  // namespace wetdeck
