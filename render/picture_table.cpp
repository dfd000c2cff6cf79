#include "render/picture_table.h"

#include "render/film/error_picture.h"

namespace hipmap {

namespace {

constexpr PictureRow kRows[] = {
    {"error-image",
     "Write an image of the relative error of each pixel in false colour, .png. Rewritten after "
     "passes",
     "an error image needs two passes or more",
     [](const RenderState& state) { return !state.checks.empty(); },
     [](const RenderState& state) {
         return FalseColour{
             error_picture(state.film.width, state.film.height, relative_errors(state.film)),
             legend_of_errors("error")};
     }},
};

} // namespace

std::span<const PictureRow> picture_rows()
{
    return kRows;
}

std::vector<RequestedPicture> requested_pictures(const std::vector<std::filesystem::path>& paths)
{
    std::vector<RequestedPicture> out;
    for (std::size_t i = 0; i < paths.size(); ++i)
        if (!paths[i].empty())
            out.push_back({&kRows[i], paths[i]});
    return out;
}

std::vector<RequestedPicture> known_pictures(const std::vector<std::filesystem::path>& paths,
                                             const RenderState& state)
{
    std::vector<RequestedPicture> out = requested_pictures(paths);
    std::erase_if(out, [&](const RequestedPicture& of) { return !of.row->is_known(state); });
    return out;
}

LegendedPicture write_picture(const RequestedPicture& picture, const RenderState& state)
{
    const FalseColour drawn = picture.row->draw(state);
    return write_with_legend(picture.path, drawn.image, drawn.legend);
}

} // namespace hipmap
