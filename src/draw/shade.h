// A curved mesh as it is seen: what hides what, and in which light.
#pragma once

#include <string>
#include <vector>

#include "draw/raster.h"
#include "draw/tint.h"
#include "draw/view.h"

namespace alphamst::draw {

class Scene {
public:
    Scene(const io::Arrays &mesh, const Drawing &drawing);

    // The faces to draw, the farthest first, so that each may be drawn over those before. Those that face
    // away from the eye are left out of a closed mesh, and so are those with others in front of them.
    const std::vector<std::size_t> &faces() const { return faces_; }
    // Colour of a face: the lighter, the more it is turned to the light, which comes from above on the
    // left; blue-grey outside, sand-coloured inside.
    std::string tone(std::size_t face) const;
    // The same from one's own colour, which is darker away from the light.
    std::string tone(std::size_t face, const Colour &colour) const;
    bool shows(std::int32_t vertex) const;
    bool shows_edge(std::int32_t v, std::int32_t w) const; // its middle

private:
    bool is_away(std::size_t face) const;
    bool shows_inside(std::size_t face) const;
    double level(std::size_t face) const; // of the light, 0 .. 1

    const io::Arrays &mesh_;
    const Drawing &drawing_;
    Raster raster_;
    bool closed_;
    double outside_ = 1; // -1: normals point into the closed mesh
    std::vector<std::size_t> faces_;
    std::vector<bool> is_corner_; // per vertex: of a face to draw
};

} // namespace alphamst::draw
