#include "quadrangulate/joining.h"

#include <unordered_map>

#include "index.h"
#include "quadrangulate/halve.h"

namespace alphamst::quadrangulate {
namespace {

using Edge = std::array<std::int32_t, 2>;

class Joining {
public:
    Joining(const Triangles &paired, QuadArrays &quads)
        : faces_(paired.faces), paired_(paired), quads_(quads) {}

    std::vector<Edge> run() {
        for (std::size_t f = 0; f < choices().size(); ++f)
            switch (choices()[f].kind) {
            case Choice::Kind::none:
                keep(f);
                break;
            case Choice::Kind::merge:
                merge(f);
                break;
            case Choice::Kind::halve:
                halve_side(f);
                break;
            case Choice::Kind::cross:
                if (const Cross &cross = paired_.pairing.crosses[at(choices()[f].mate)];
                    cross.faces[0] == static_cast<std::int32_t>(f))
                    add_face(quads_, origin(f), cross.corners);
                break;
            case Choice::Kind::split:
                split_face(quads_, faces_, f, origin(f), [&](std::size_t c) { return midpoint(c); });
                break;
            }
        return std::move(flat_);
    }

private:
    const std::vector<Choice> &choices() const { return paired_.pairing.choices; }

    std::int32_t origin(std::size_t f) const {
        return paired_.origin.empty() ? static_cast<std::int32_t>(f) : paired_.origin[f];
    }

    void keep(std::size_t f) {
        add_face(quads_, origin(f), {faces_[4 * f], faces_[4 * f + 1], faces_[4 * f + 2], faces_[4 * f + 3]});
    }

    void merge(std::size_t f) {
        if (choices()[f].mate < static_cast<std::int32_t>(f))
            return;
        const std::size_t c = 4 * f + at(choices()[f].side), next = mesh::next_corner(faces_, c);
        const TriangleSides &sides = paired_.sides;
        if (!sides.diagonals.empty() && sides.diagonals[c]) {
            const std::size_t given = 4 * at(origin(f));
            add_face(quads_, origin(f),
                     {paired_.given[given], paired_.given[given + 1], paired_.given[given + 2],
                      paired_.given[given + 3]});
            return;
        }
        if (sides.bars[c] != Bar::none) // as none other was left
            quads_.crossed.push_back({faces_[c], faces_[next]});
        const std::size_t other = mesh::next_corner(faces_, mesh::next_corner(faces_, at(sides.across[c])));
        add_face(quads_, origin(f),
                 {faces_[c], faces_[other], faces_[next], faces_[mesh::next_corner(faces_, next)]});
    }

    void halve_side(std::size_t f) {
        const std::size_t c = 4 * f + at(choices()[f].side), next = mesh::next_corner(faces_, c);
        const std::int32_t vertex = midpoint(c);
        add_face(quads_, origin(f),
                 {faces_[c], vertex, faces_[next], faces_[mesh::next_corner(faces_, next)]});
        flat_.push_back({faces_[c], vertex});
    }

    std::int32_t midpoint(std::size_t corner) {
        const std::int32_t beyond = paired_.sides.across[corner];
        const auto [place, is_new] =
            midpoints_.try_emplace(beyond < 0 ? corner : std::min(corner, at(beyond)), -1);
        if (is_new)
            place->second = halve(quads_, faces_[corner], faces_[mesh::next_corner(faces_, corner)]);
        return place->second;
    }

    mesh::Faces faces_;
    const Triangles &paired_;
    QuadArrays &quads_;
    std::vector<Edge> flat_;
    std::unordered_map<std::size_t, std::int32_t> midpoints_; // at the first corner of their sides
};

} // namespace

std::vector<Edge> join(const Triangles &paired, QuadArrays &quads) { return Joining(paired, quads).run(); }

} // namespace alphamst::quadrangulate
