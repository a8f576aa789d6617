// Compiled from forward.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: d55c4bbde9563be5
// result: c8c8767753ace8b3

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) room_0 : u32,
    @align(4) depth_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(5) @group(0) var<storage, read> input_0 : array<u32>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

@binding(4) @group(0) var<storage, read> scene_0 : array<u32>;

@binding(2) @group(0) var<storage, read> primitives_0 : array<f32>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

fn path_word_0( path_0 : u32,  which_0 : u32) -> u32
{
    return paths_0[which_0 * launch_0.room_0 + path_0];
}

fn path_vector_0( path_1 : u32,  which_1 : ptr<function, u32>) -> vec3<f32>
{
    var _S1 : u32 = (*which_1) + u32(3);
    (*which_1) = _S1;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_1, _S1 - u32(3)), path_word_0(path_1, _S1 - u32(2)), path_word_0(path_1, _S1 - u32(1))))));
}

fn path_vector_1( path_2 : u32,  which_2 : ptr<function, u32>) -> vec3<f32>
{
    var _S2 : u32 = (*which_2) + u32(3);
    (*which_2) = _S2;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_2, _S2 - u32(3)), path_word_0(path_2, _S2 - u32(2)), path_word_0(path_2, _S2 - u32(1))))));
}

struct Colour_0
{
     value_0 : vec3<f32>,
     changes_0 : array<vec3<f32>, i32(1)>,
};

fn path_colour_0( path_3 : u32,  which_3 : ptr<function, u32>) -> Colour_0
{
    var colour_0 : Colour_0;
    var _S3 : vec3<f32> = path_vector_1(path_3, &((*which_3)));
    colour_0.value_0 = _S3;
    var k_0 : u32 = u32(0);
    for(;;)
    {
        if(k_0 < u32(1))
        {
        }
        else
        {
            break;
        }
        var _S4 : vec3<f32> = path_vector_1(path_3, &((*which_3)));
        colour_0.changes_0[k_0] = _S4;
        k_0 = k_0 + u32(1);
    }
    return colour_0;
}

struct Place_0
{
     triangle_0 : u32,
     v_0 : f32,
     w_0 : f32,
};

fn path_place_0( path_4 : u32,  which_4 : ptr<function, u32>) -> Place_0
{
    var place_0 : Place_0;
    place_0.triangle_0 = path_word_0(path_4, (*which_4));
    place_0.v_0 = (bitcast<f32>((path_word_0(path_4, (*which_4) + u32(1)))));
    place_0.w_0 = (bitcast<f32>((path_word_0(path_4, (*which_4) + u32(2)))));
    (*which_4) = (*which_4) + u32(3);
    return place_0;
}

struct Path_0
{
     throughput_0 : Colour_0,
     direction_0 : vec3<f32>,
     place_1 : Place_0,
     key_0 : vec2<u32>,
     light_0 : Colour_0,
};

fn load_0( number_of_path_0 : u32) -> Path_0
{
    var at_0 : u32 = u32(1);
    var path_5 : Path_0;
    var _S5 : Colour_0 = path_colour_0(number_of_path_0, &(at_0));
    path_5.light_0 = _S5;
    var _S6 : Colour_0 = path_colour_0(number_of_path_0, &(at_0));
    path_5.throughput_0 = _S6;
    var _S7 : vec3<f32> = path_vector_0(number_of_path_0, &(at_0));
    path_5.direction_0 = _S7;
    var _S8 : Place_0 = path_place_0(number_of_path_0, &(at_0));
    path_5.place_1 = _S8;
    path_5.key_0 = vec2<u32>(path_word_0(number_of_path_0, at_0), path_word_0(number_of_path_0, at_0 + u32(1)));
    return path_5;
}

fn constant_0( value_1 : vec3<f32>) -> Colour_0
{
    var colour_1 : Colour_0;
    colour_1.value_0 = value_1;
    var k_1 : u32 = u32(0);
    for(;;)
    {
        if(k_1 < u32(1))
        {
        }
        else
        {
            break;
        }
        colour_1.changes_0[k_1] = vec3<f32>(0.0f);
        k_1 = k_1 + u32(1);
    }
    return colour_1;
}

struct Vertex_0
{
     direct_0 : Colour_0,
     onward_0 : Colour_0,
     textures_0 : array<u32, i32(2)>,
};

fn dark_vertex_0() -> Vertex_0
{
    var vertex_0 : Vertex_0;
    var _S9 : Colour_0 = constant_0(vec3<f32>(0.0f));
    vertex_0.direct_0 = _S9;
    vertex_0.onward_0 = _S9;
    vertex_0.textures_0[i32(0)] = u32(4294967295);
    vertex_0.textures_0[i32(1)] = u32(4294967295);
    return vertex_0;
}

fn word_0( at_1 : u32) -> u32
{
    return scene_0[at_1];
}

fn vertex_numbers_0( depth_1 : u32) -> u32
{
    return word_0(u32(7)) + depth_1 * (u32(3) * word_0(u32(2)) + u32(3) * word_0(u32(3)) + u32(1));
}

fn triangle_record_0( triangle_1 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_1;
}

fn shape_of_0( triangle_2 : u32) -> u32
{
    return word_0(u32(10)) + u32(5) * word_0(triangle_record_0(triangle_2));
}

fn primitive_vector_0( at_2 : u32) -> vec3<f32>
{
    return vec3<f32>(primitives_0[at_2], primitives_0[at_2 + u32(1)], primitives_0[at_2 + u32(2)]);
}

fn position_of_0( place_2 : Place_0) -> vec3<f32>
{
    var at_3 : u32 = u32(9) * place_2.triangle_0;
    var a_0 : vec3<f32> = primitive_vector_0(at_3);
    return a_0 + (primitive_vector_0(at_3 + u32(3)) - a_0) * vec3<f32>(place_2.v_0) + (primitive_vector_0(at_3 + u32(6)) - a_0) * vec3<f32>(place_2.w_0);
}

fn cross_of_0( triangle_3 : u32) -> vec3<f32>
{
    var at_4 : u32 = u32(9) * triangle_3;
    var a_1 : vec3<f32> = primitive_vector_0(at_4);
    return cross(primitive_vector_0(at_4 + u32(3)) - a_1, primitive_vector_0(at_4 + u32(6)) - a_1);
}

fn unit_0( v_1 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_1 / vec3<f32>(max(max(abs(v_1.x), abs(v_1.y)), abs(v_1.z))));
}

fn number_0( at_5 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_5])));
}

fn vector_at_0( at_6 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_6), number_0(at_6 + u32(1)), number_0(at_6 + u32(2)));
}

struct Surface_0
{
     place_3 : Place_0,
     shape_0 : u32,
     exact_0 : vec3<f32>,
     position_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     outward_0 : vec3<f32>,
     is_front_0 : bool,
};

fn surface_at_0( place_4 : Place_0,  direction_1 : vec3<f32>) -> Surface_0
{
    var surface_0 : Surface_0;
    surface_0.place_3 = place_4;
    surface_0.shape_0 = shape_of_0(place_4.triangle_0);
    var _S10 : vec3<f32> = position_of_0(place_4);
    surface_0.exact_0 = _S10;
    surface_0.position_0 = _S10;
    var _S11 : vec3<f32> = unit_0(cross_of_0(place_4.triangle_0));
    surface_0.face_normal_0 = _S11;
    surface_0.outward_0 = _S11;
    var seen_0 : f32;
    if((dot(_S11, direction_1)) > 0.0f)
    {
        seen_0 = -1.0f;
    }
    else
    {
        seen_0 = 1.0f;
    }
    var normals_0 : u32 = word_0(surface_0.shape_0);
    if(normals_0 != u32(4294967295))
    {
        var record_0 : u32 = triangle_record_0(place_4.triangle_0) + u32(2);
        var a_2 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0));
        var b_0 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0 + u32(1)));
        var c_0 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0 + u32(2)));
        if((dot(a_2 + b_0 + c_0, surface_0.face_normal_0)) < 0.0f)
        {
            seen_0 = - seen_0;
        }
        surface_0.outward_0 = normalize(a_2 + (b_0 - a_2) * vec3<f32>(place_4.v_0) + (c_0 - a_2) * vec3<f32>(place_4.w_0));
    }
    surface_0.is_front_0 = seen_0 > 0.0f;
    return surface_0;
}

struct Lookup_0
{
     count_0 : u32,
     texels_0 : vec4<u32>,
     weights_0 : vec4<f32>,
};

fn one_texel_0( texel_0 : u32) -> Lookup_0
{
    var lookup_0 : Lookup_0;
    lookup_0.count_0 = u32(1);
    lookup_0.texels_0 = vec4<u32>(texel_0, u32(0), u32(0), u32(0));
    lookup_0.weights_0 = vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f);
    return lookup_0;
}

fn uv_of_0( place_5 : Place_0) -> vec2<f32>
{
    var uvs_0 : u32 = word_0(shape_of_0(place_5.triangle_0) + u32(1));
    if(uvs_0 == u32(4294967295))
    {
        return vec2<f32>(place_5.v_0, place_5.w_0);
    }
    var at_7 : u32 = uvs_0 + u32(6) * word_0(triangle_record_0(place_5.triangle_0) + u32(1));
    return vec2<f32>(number_0(at_7), number_0(at_7 + u32(1))) * vec2<f32>((1.0f - place_5.v_0 - place_5.w_0)) + vec2<f32>(number_0(at_7 + u32(2)), number_0(at_7 + u32(3))) * vec2<f32>(place_5.v_0) + vec2<f32>(number_0(at_7 + u32(4)), number_0(at_7 + u32(5))) * vec2<f32>(place_5.w_0);
}

fn floor_of_0( x_0 : f32) -> i32
{
    return i32(floor(clamp(x_0, -1.0e+09f, 1.0e+09f)));
}

fn wrapped_0( i_0 : i32,  n_0 : i32,  wrap_0 : u32) -> u32
{
    if(wrap_0 == u32(2))
    {
        return u32(clamp(i_0, i32(0), n_0 - i32(1)));
    }
    var period_0 : i32;
    if(wrap_0 == u32(1))
    {
        period_0 = i32(2) * n_0;
    }
    else
    {
        period_0 = n_0;
    }
    var inside_0 : i32 = i_0 % period_0;
    var inside_1 : i32;
    if(inside_0 < i32(0))
    {
        inside_1 = inside_0 + period_0;
    }
    else
    {
        inside_1 = inside_0;
    }
    if(inside_1 < n_0)
    {
        period_0 = inside_1;
    }
    else
    {
        period_0 = i32(2) * n_0 - i32(1) - inside_1;
    }
    return u32(period_0);
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : vec2<f32>) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var place_6 : vec2<f32> = uv_0 * vec2<f32>(f32(width_0), f32(height_0));
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_6.y), height_0, wrap_1);
        var _S12 : u32 = row_0 * u32(width_0);
        var _S13 : u32 = wrapped_0(floor_of_0(place_6.x), width_0, wrap_1);
        return one_texel_0(_S12 + _S13);
    }
    var place_7 : vec2<f32> = place_6 - vec2<f32>(0.5f);
    var x_1 : i32 = floor_of_0(place_7.x);
    var y_0 : i32 = floor_of_0(place_7.y);
    var way_0 : vec2<f32> = place_7 - floor(place_7);
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - way_0;
    var _S14 : u32 = wrapped_0(y_0, height_0, wrap_1);
    var _S15 : u32 = u32(width_0);
    var first_1 : u32 = _S14 * _S15;
    var _S16 : u32 = wrapped_0(y_0 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S16 * _S15;
    var left_0 : u32 = wrapped_0(x_1, width_0, wrap_1);
    var right_0 : u32 = wrapped_0(x_1 + i32(1), width_0, wrap_1);
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0);
    var _S17 : f32 = back_0.x;
    var _S18 : f32 = back_0.y;
    var _S19 : f32 = way_0.x;
    var _S20 : f32 = way_0.y;
    lookup_1.weights_0 = vec4<f32>(_S17 * _S18, _S19 * _S18, _S17 * _S20, _S19 * _S20);
    return lookup_1;
}

fn lookup_at_0( texture_1 : u32,  place_8 : Place_0) -> Lookup_0
{
    var kind_0 : u32 = word_0(texture_1);
    if(kind_0 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_1 : u32 = triangle_record_0(place_8.triangle_0) + u32(1);
    if(kind_0 == u32(4))
    {
        return one_texel_0(word_0(record_1));
    }
    if(kind_0 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_1 + u32(1)), word_0(record_1 + u32(2)), word_0(record_1 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_8.v_0 - place_8.w_0, place_8.v_0, place_8.w_0, 0.0f);
        return lookup_2;
    }
    var rows_0 : u32 = texture_1 + u32(6);
    var _S21 : vec3<f32> = vec3<f32>(uv_of_0(place_8), 1.0f);
    var uv_1 : vec2<f32> = vec2<f32>(dot(_S21, vector_at_0(rows_0)), dot(_S21, vector_at_0(rows_0 + u32(3))));
    if(kind_0 == u32(1))
    {
        var _S22 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S22;
    }
    var half_of_period_0 : vec2<f32> = uv_1 - floor(uv_1);
    var _S23 : i32;
    if(((half_of_period_0.x) > 0.5f) != ((half_of_period_0.y) > 0.5f))
    {
        _S23 = i32(1);
    }
    else
    {
        _S23 = i32(0);
    }
    return one_texel_0(u32(_S23));
}

fn texture_value_0( texture_2 : u32,  lookup_3 : Lookup_0) -> vec3<f32>
{
    var _S24 : u32 = word_0(texture_2 + u32(1));
    var _S25 : u32 = texture_2 + u32(13);
    var _S26 : vec3<f32> = vec3<f32>(0.0f);
    var k_2 : u32 = u32(0);
    var value_2 : vec3<f32> = _S26;
    for(;;)
    {
        if(k_2 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_8 : u32 = _S25 + _S24 * lookup_3.texels_0[k_2];
        var _S27 : vec3<f32>;
        if(_S24 == u32(1))
        {
            _S27 = vec3<f32>(number_0(at_8));
        }
        else
        {
            _S27 = vector_at_0(at_8);
        }
        var value_3 : vec3<f32> = value_2 + _S27 * vec3<f32>(lookup_3.weights_0[k_2]);
        k_2 = k_2 + u32(1);
        value_2 = value_3;
    }
    return value_2;
}

fn change_word_0( at_9 : u32) -> u32
{
    return input_0[u32(9) * launch_0.room_0 + at_9];
}

fn numbers_of_0( texture_3 : u32) -> u32
{
    return change_word_0(u32(2) * word_0(texture_3 + u32(12)));
}

fn colour_at_0( texture_4 : u32,  place_9 : Place_0,  slot_0 : u32) -> Colour_0
{
    var lookup_4 : Lookup_0 = lookup_at_0(texture_4, place_9);
    var colour_2 : Colour_0 = constant_0(texture_value_0(texture_4, lookup_4));
    var first_2 : u32 = numbers_of_0(texture_4);
    if(first_2 == u32(4294967295))
    {
        return colour_2;
    }
    var _S28 : u32 = word_0(texture_4 + u32(1));
    var k_3 : u32 = u32(0);
    for(;;)
    {
        if(k_3 < (lookup_4.count_0))
        {
        }
        else
        {
            break;
        }
        var at_10 : u32 = first_2 + _S28 * lookup_4.texels_0[k_3];
        var change_0 : vec3<f32> = (bitcast<vec3<f32>>((vec3<u32>(change_word_0(at_10)))));
        if(_S28 == u32(3))
        {
            var _S29 : vec2<f32> = (bitcast<vec2<f32>>((vec2<u32>(change_word_0(at_10 + u32(1)), change_word_0(at_10 + u32(2))))));
            change_0.y = _S29.x;
            change_0.z = _S29.y;
        }
        colour_2.changes_0[i32(0)] = colour_2.changes_0[i32(0)] + change_0 * vec3<f32>(lookup_4.weights_0[k_3]);
        k_3 = k_3 + u32(1);
    }
    return colour_2;
}

struct Axes_0
{
     s_0 : vec3<f32>,
     t_0 : vec3<f32>,
     n_1 : vec3<f32>,
};

fn axes_at_0( surface_1 : Surface_0) -> Axes_0
{
    var _S30 : f32 = surface_1.outward_0.z;
    var sign_0 : f32;
    if(_S30 < 0.0f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var a_3 : f32 = -1.0f / (sign_0 + _S30);
    var _S31 : f32 = surface_1.outward_0.x;
    var _S32 : f32 = surface_1.outward_0.y;
    var b_1 : f32 = _S31 * _S32 * a_3;
    var axes_0 : Axes_0;
    axes_0.s_0 = vec3<f32>(1.0f + sign_0 * _S31 * _S31 * a_3, sign_0 * b_1, - sign_0 * _S31);
    axes_0.t_0 = vec3<f32>(b_1, sign_0 + _S32 * _S32 * a_3, - _S32);
    var _S33 : vec3<f32>;
    if(surface_1.is_front_0)
    {
        _S33 = surface_1.outward_0;
    }
    else
    {
        _S33 = (vec3<f32>(0) - surface_1.outward_0);
    }
    axes_0.n_1 = _S33;
    return axes_0;
}

fn reaches_0( segments_0 : u32) -> bool
{
    return segments_0 <= (word_0(u32(0)));
}

fn emitter_record_0( emitter_0 : u32) -> u32
{
    return word_0(u32(11)) + u32(12) * emitter_0;
}

fn node_seen_0( node_0 : u32,  viewpoint_0 : vec3<f32>) -> f32
{
    var offset_0 : vec3<f32> = viewpoint_0 - vector_at_0(node_0 + u32(4));
    var axis_0 : vec3<f32> = vector_at_0(node_0 + u32(12));
    var radius_0 : f32 = number_0(node_0 + u32(7));
    var area_0 : f32 = number_0(node_0 + u32(11));
    var cosine_spread_0 : f32 = number_0(node_0 + u32(15));
    var sine_spread_0 : f32 = number_0(node_0 + u32(16));
    var squared_0 : f32 = dot(offset_0, offset_0);
    var distance_0 : f32 = sqrt(squared_0);
    if(distance_0 <= radius_0)
    {
        return 0.25f * area_0 / max(radius_0 * radius_0, 1.00000000317107685e-30f);
    }
    var cosine_0 : f32 = clamp(dot(axis_0, offset_0) / distance_0, -1.0f, 1.0f);
    var sine_0 : f32 = sqrt(1.0f - cosine_0 * cosine_0);
    var tilt_0 : f32 = radius_0 / distance_0;
    var highest_0 : f32;
    if(cosine_0 >= cosine_spread_0)
    {
        highest_0 = 1.0f;
    }
    else
    {
        highest_0 = cosine_0 * cosine_spread_0 + sine_0 * sine_spread_0 + tilt_0;
    }
    var lowest_0 : f32;
    if(cosine_0 <= (- cosine_spread_0))
    {
        lowest_0 = -1.0f;
    }
    else
    {
        lowest_0 = cosine_0 * cosine_spread_0 - sine_0 * sine_spread_0 - tilt_0;
    }
    if(highest_0 <= 0.0f)
    {
        return 0.0f;
    }
    if(lowest_0 >= 0.0f)
    {
        return max(dot(vector_at_0(node_0 + u32(8)), offset_0) / distance_0, 0.0f) / squared_0;
    }
    var _S34 : f32 = min(highest_0, 1.0f);
    return area_0 * _S34 * _S34 / (2.0f * (_S34 - max(lowest_0, -1.0f)) * squared_0);
}

fn is_sampled_well_0( position_1 : vec3<f32>) -> bool
{
    var _S35 : bool;
    if((word_0(u32(6))) != u32(1))
    {
        _S35 = true;
    }
    else
    {
        _S35 = (word_0(u32(2))) == u32(0);
    }
    if(_S35)
    {
        return false;
    }
    var record_2 : u32 = emitter_record_0(u32(0));
    if((word_0(record_2)) != u32(0))
    {
        _S35 = (node_seen_0(word_0(record_2 + u32(5)), position_1)) < 1.0f;
    }
    else
    {
        _S35 = false;
    }
    return _S35;
}

fn largest_cosine_0( position_2 : vec3<f32>,  normal_0 : vec3<f32>,  centre_0 : vec3<f32>,  radius_1 : f32) -> f32
{
    var offset_1 : vec3<f32> = centre_0 - position_2;
    var distance_1 : f32 = length(offset_1);
    if(distance_1 <= radius_1)
    {
        return 1.0f;
    }
    var cosine_1 : f32 = dot(offset_1, normal_0) / distance_1;
    var sine_ball_0 : f32 = radius_1 / distance_1;
    var cosine_ball_0 : f32 = sqrt(max(1.0f - sine_ball_0 * sine_ball_0, 0.0f));
    if(cosine_1 >= cosine_ball_0)
    {
        return 1.0f;
    }
    return max(cosine_1 * cosine_ball_0 + sqrt(max(1.0f - cosine_1 * cosine_1, 0.0f)) * sine_ball_0 + 9.99999997475242708e-07f, 0.0f);
}

fn emitter_view_0( emitter_1 : u32,  position_3 : vec3<f32>,  normal_1 : vec3<f32>) -> f32
{
    var record_3 : u32 = emitter_record_0(emitter_1);
    if((word_0(record_3)) == u32(0))
    {
        return 3.14159274101257324f;
    }
    return node_seen_0(word_0(record_3 + u32(5)), position_3) * largest_cosine_0(position_3, normal_1, vector_at_0(record_3 + u32(8)), number_0(record_3 + u32(11)));
}

struct Choice_0
{
     position_4 : vec3<f32>,
     normal_2 : vec3<f32>,
     all_0 : f32,
     lit_0 : f32,
};

fn light_of_0( emitter_2 : u32,  choice_0 : Choice_0,  can_light_0 : ptr<function, f32>) -> f32
{
    var view_0 : f32 = emitter_view_0(emitter_2, choice_0.position_4, choice_0.normal_2);
    var _S36 : f32;
    if(view_0 > 0.0f)
    {
        _S36 = 1.0f;
    }
    else
    {
        _S36 = 0.0f;
    }
    (*can_light_0) = _S36;
    return view_0 * number_0(emitter_record_0(emitter_2) + u32(2));
}

fn light_of_1( emitter_3 : u32,  choice_1 : Choice_0,  can_light_1 : ptr<function, f32>) -> f32
{
    var view_1 : f32 = emitter_view_0(emitter_3, choice_1.position_4, choice_1.normal_2);
    var _S37 : f32;
    if(view_1 > 0.0f)
    {
        _S37 = 1.0f;
    }
    else
    {
        _S37 = 0.0f;
    }
    (*can_light_1) = _S37;
    return view_1 * number_0(emitter_record_0(emitter_3) + u32(2));
}

fn choice_at_0( position_5 : vec3<f32>,  normal_3 : vec3<f32>) -> Choice_0
{
    var choice_2 : Choice_0;
    choice_2.position_4 = position_5;
    choice_2.normal_2 = normal_3;
    choice_2.all_0 = 0.0f;
    choice_2.lit_0 = 0.0f;
    var count_1 : u32 = word_0(u32(6));
    var _S38 : bool;
    if((word_0(u32(5))) != u32(0))
    {
        _S38 = true;
    }
    else
    {
        _S38 = count_1 < u32(2);
    }
    if(_S38)
    {
        _S38 = true;
    }
    else
    {
        _S38 = count_1 > u32(32);
    }
    if(_S38)
    {
        return choice_2;
    }
    var i_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < count_1)
        {
        }
        else
        {
            break;
        }
        var can_light_2 : f32;
        var _S39 : f32 = light_of_1(i_1, choice_2, &(can_light_2));
        choice_2.all_0 = choice_2.all_0 + _S39;
        choice_2.lit_0 = choice_2.lit_0 + can_light_2;
        i_1 = i_1 + u32(1);
    }
    if((choice_2.all_0) > 0.0f)
    {
        _S38 = (choice_2.all_0) < 3.00000000549775576e+38f;
    }
    else
    {
        _S38 = false;
    }
    if(!_S38)
    {
        choice_2.all_0 = 0.0f;
    }
    return choice_2;
}

fn product_0( a_4 : u32,  b_2 : u32) -> vec2<u32>
{
    var a0_0 : u32 = (a_4 & (u32(65535)));
    var a1_0 : u32 = (a_4 >> (u32(16)));
    var b0_0 : u32 = (b_2 & (u32(65535)));
    var b1_0 : u32 = (b_2 >> (u32(16)));
    var low_0 : u32 = a0_0 * b0_0;
    var middle_0 : u32 = a1_0 * b0_0 + ((low_0 >> (u32(16))));
    var rest_0 : u32 = ((middle_0 & (u32(65535)))) + a0_0 * b1_0;
    return vec2<u32>((((rest_0 << (u32(16)))) | (((low_0 & (u32(65535)))))), a1_0 * b1_0 + ((middle_0 >> (u32(16)))) + ((rest_0 >> (u32(16)))));
}

fn times_0( a_5 : vec2<u32>,  b_3 : vec2<u32>) -> vec2<u32>
{
    var _S40 : u32 = a_5.x;
    var _S41 : u32 = b_3.x;
    var low_1 : vec2<u32> = product_0(_S40, _S41);
    return vec2<u32>(low_1.x, low_1.y + _S40 * b_3.y + a_5.y * _S41);
}

fn plus_0( a_6 : vec2<u32>,  b_4 : vec2<u32>) -> vec2<u32>
{
    var _S42 : u32 = a_6.x;
    var low_2 : u32 = _S42 + b_4.x;
    var _S43 : u32 = a_6.y + b_4.y;
    var _S44 : i32;
    if(low_2 < _S42)
    {
        _S44 = i32(1);
    }
    else
    {
        _S44 = i32(0);
    }
    return vec2<u32>(low_2, _S43 + u32(_S44));
}

fn shifted_xor_0( x_2 : vec2<u32>,  by_0 : u32) -> vec2<u32>
{
    var _S45 : u32 = x_2.y;
    return (x_2 ^ (vec2<u32>(((((x_2.x) >> (by_0))) | (((_S45 << ((u32(32) - by_0)))))), (_S45 >> (by_0)))));
}

fn mix_0( x_3 : vec2<u32>) -> vec2<u32>
{
    return shifted_xor_0(times_0(shifted_xor_0(times_0(shifted_xor_0(x_3, u32(30)), vec2<u32>(u32(484763065), u32(3210233709))), u32(27)), vec2<u32>(u32(321982955), u32(2496678331))), u32(31));
}

fn random_bits_0( key_1 : vec2<u32>,  dimension_0 : u32) -> vec2<u32>
{
    return mix_0(plus_0(key_1, times_0(vec2<u32>(dimension_0 + u32(1), u32(0)), vec2<u32>(u32(2135587861), u32(2654435769)))));
}

fn random_0( key_2 : vec2<u32>,  dimension_1 : u32) -> f32
{
    return f32(((random_bits_0(key_2, dimension_1).y) >> (u32(8)))) * 5.9604644775390625e-08f;
}

fn chance_of_0( emitter_4 : u32,  choice_3 : Choice_0) -> f32
{
    if((choice_3.all_0) == 0.0f)
    {
        return 1.0f / f32(word_0(u32(6)));
    }
    var can_light_3 : f32;
    var light_1 : f32 = light_of_0(emitter_4, choice_3, &(can_light_3));
    return 0.5f * can_light_3 / choice_3.lit_0 + 0.5f * light_1 / choice_3.all_0;
}

fn chosen_emitter_0( choice_4 : Choice_0,  u_0 : f32,  probability_0 : ptr<function, f32>) -> u32
{
    var count_2 : u32 = word_0(u32(6));
    (*probability_0) = 0.0f;
    if(count_2 == u32(0))
    {
        return u32(0);
    }
    if((choice_4.all_0) == 0.0f)
    {
        var _S46 : f32 = f32(count_2);
        (*probability_0) = 1.0f / _S46;
        return min(u32(u_0 * _S46), count_2 - u32(1));
    }
    var found_0 : u32 = u32(0);
    var i_2 : u32 = u32(0);
    var rest_1 : f32 = u_0;
    for(;;)
    {
        if(i_2 < count_2)
        {
        }
        else
        {
            break;
        }
        var own_0 : f32 = chance_of_0(i_2, choice_4);
        var found_1 : u32;
        if(own_0 > 0.0f)
        {
            (*probability_0) = own_0;
            found_1 = i_2;
        }
        else
        {
            found_1 = found_0;
        }
        if(rest_1 < own_0)
        {
            found_0 = found_1;
            break;
        }
        var rest_2 : f32 = rest_1 - own_0;
        var _S47 : u32 = i_2 + u32(1);
        found_0 = found_1;
        i_2 = _S47;
        rest_1 = rest_2;
    }
    return found_0;
}

fn limit_at_0( which_5 : u32) -> f32
{
    return primitives_0[word_0(u32(13)) + which_5];
}

fn angle_of_0( x_4 : f32,  y_1 : f32) -> f32
{
    var _S48 : f32 = abs(x_4);
    var _S49 : f32 = abs(y_1);
    var _S50 : f32 = min(_S48, _S49);
    var _S51 : f32 = max(_S48, _S49);
    var is_steep_0 : bool = _S50 > (0.41421356797218323f * _S51);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S50 - _S51;
    }
    else
    {
        above_0 = _S50;
    }
    var below_0 : f32;
    if(is_steep_0)
    {
        below_0 = _S50 + _S51;
    }
    else
    {
        below_0 = _S51;
    }
    if(below_0 > 0.0f)
    {
    }
    else
    {
        below_0 = 1.0f;
    }
    var t_1 : f32 = above_0 / below_0;
    var z_0 : f32 = t_1 * t_1;
    var angle_0 : f32 = (((0.08053744584321976f * z_0 - 0.13877685368061066f) * z_0 + 0.19977711141109467f) * z_0 - 0.33332949876785278f) * z_0 * t_1 + t_1;
    var angle_1 : f32;
    if(is_steep_0)
    {
        angle_1 = angle_0 + 0.78539818525314331f;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(_S49 > _S48)
    {
        angle_1 = 1.57079637050628662f - angle_1;
    }
    if(x_4 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(y_1 < 0.0f)
    {
        above_0 = - angle_1;
    }
    else
    {
        above_0 = angle_1;
    }
    return above_0;
}

fn solid_angle_of_0( a_7 : vec3<f32>,  b_5 : vec3<f32>,  c_1 : vec3<f32>) -> f32
{
    var la_0 : f32 = length(a_7);
    var lb_0 : f32 = length(b_5);
    var lc_0 : f32 = length(c_1);
    var normal_4 : vec3<f32> = cross(b_5 - a_7, c_1 - a_7);
    var volume_0 : f32 = - dot(a_7, normal_4);
    if(!(volume_0 > (9.99999997475242708e-07f * max(max(la_0, lb_0), lc_0) * length(normal_4))))
    {
        return 0.0f;
    }
    return 2.0f * angle_of_0(la_0 * lb_0 * lc_0 + dot(a_7, b_5) * lc_0 + dot(b_5, c_1) * la_0 + dot(c_1, a_7) * lb_0, volume_0);
}

fn complex_product_0( a_8 : vec2<f32>,  b_6 : vec2<f32>) -> vec2<f32>
{
    var _S52 : f32 = a_8.x;
    var _S53 : f32 = b_6.x;
    var _S54 : f32 = a_8.y;
    var _S55 : f32 = b_6.y;
    return vec2<f32>(_S52 * _S53 - _S54 * _S55, _S52 * _S55 + _S54 * _S53);
}

struct SeenRectangle_0
{
     x_5 : vec2<f32>,
     y_2 : vec2<f32>,
     z_1 : f32,
     solid_angle_0 : f32,
     start_0 : vec2<f32>,
     inverse_to_line_0 : vec2<f32>,
};

fn seen_rectangle_0( at_11 : u32,  viewpoint_1 : vec3<f32>) -> SeenRectangle_0
{
    var offset_2 : vec3<f32> = vector_at_0(at_11) - viewpoint_1;
    var x0_0 : f32 = dot(vector_at_0(at_11 + u32(3)), offset_2);
    var y0_0 : f32 = dot(vector_at_0(at_11 + u32(6)), offset_2);
    var x1_0 : f32 = x0_0 + number_0(at_11 + u32(12));
    var y1_0 : f32 = y0_0 + number_0(at_11 + u32(13));
    var seen_1 : SeenRectangle_0;
    seen_1.x_5 = vec2<f32>(x0_0, x1_0);
    seen_1.y_2 = vec2<f32>(y0_0, y1_0);
    var _S56 : f32 = - dot(vector_at_0(at_11 + u32(9)), offset_2);
    seen_1.z_1 = _S56;
    var a_9 : vec3<f32> = vec3<f32>(x0_0, y0_0, _S56);
    var b_7 : vec3<f32> = vec3<f32>(x1_0, y0_0, _S56);
    var c_2 : vec3<f32> = vec3<f32>(x0_0, y1_0, _S56);
    var d_0 : vec3<f32> = vec3<f32>(x1_0, y1_0, _S56);
    var _S57 : f32 = length(a_9);
    var _S58 : f32 = length(c_2);
    var _S59 : f32;
    if(_S56 > (9.99999997475242708e-07f * max(max(_S57, length(b_7)), max(_S58, length(d_0)))))
    {
        _S59 = solid_angle_of_0(a_9, c_2, b_7) + solid_angle_of_0(d_0, b_7, c_2);
    }
    else
    {
        _S59 = 0.0f;
    }
    seen_1.solid_angle_0 = _S59;
    var z2_0 : f32 = seen_1.z_1 * seen_1.z_1;
    var at_first_0 : vec2<f32> = complex_product_0(vec2<f32>(x0_0 * y1_0, seen_1.z_1 * _S58), vec2<f32>(- x0_0 * y0_0, seen_1.z_1 * _S57));
    var to_line_0 : vec2<f32> = sqrt(seen_1.y_2 * seen_1.y_2 + vec2<f32>(z2_0));
    seen_1.start_0 = vec2<f32>(at_first_0.x, - at_first_0.y) * vec2<f32>((1.0f / ((x0_0 * x0_0 + z2_0) * to_line_0.x * to_line_0.y)));
    seen_1.inverse_to_line_0 = vec2<f32>(1.0f) / to_line_0;
    return seen_1;
}

fn sine_cosine_0( angle_2 : f32) -> vec2<f32>
{
    var quarters_0 : f32 = floor(angle_2 * 0.63661974668502808f + 0.5f);
    var x_6 : f32 = angle_2 - quarters_0 * 1.5703125f - quarters_0 * 0.00048375129699707f - quarters_0 * 7.54979012640433211e-08f;
    var z_2 : f32 = x_6 * x_6;
    var sine_1 : f32 = ((-0.00019515295571182f * z_2 + 0.00833216123282909f) * z_2 - 0.16666655242443085f) * z_2 * x_6 + x_6;
    var cosine_2 : f32 = ((0.00002443315679557f * z_2 - 0.00138873164542019f) * z_2 + 0.04166664555668831f) * z_2 * z_2 - 0.5f * z_2 + 1.0f;
    var quarter_0 : i32 = (i32(quarters_0) & (i32(3)));
    var turned_0 : vec2<f32>;
    if(((quarter_0 & (i32(1)))) != i32(0))
    {
        turned_0 = vec2<f32>(cosine_2, - sine_1);
    }
    else
    {
        turned_0 = vec2<f32>(sine_1, cosine_2);
    }
    if(quarter_0 < i32(2))
    {
    }
    else
    {
        turned_0 = (vec2<f32>(0) - turned_0);
    }
    return turned_0;
}

fn rectangle_place_0( seen_2 : SeenRectangle_0,  u_1 : vec2<f32>) -> vec2<f32>
{
    var turn_0 : vec2<f32> = sine_cosine_0(u_1.x * seen_2.solid_angle_0);
    var at_12 : vec2<f32> = complex_product_0(seen_2.start_0, vec2<f32>(turn_0.y, turn_0.x));
    var _S60 : f32 = seen_2.y_2.x;
    var _S61 : f32 = seen_2.inverse_to_line_0.x;
    var _S62 : f32 = seen_2.y_2.y;
    var n_2 : f32 = - at_12.x * _S60 * _S61 - _S62 * seen_2.inverse_to_line_0.y;
    var _S63 : f32 = at_12.y;
    var flat_0 : f32 = _S63 * seen_2.z_1 * _S61;
    var size_0 : f32 = seen_2.z_1 * abs(_S63) / sqrt(max(n_2 * n_2 - flat_0 * flat_0, 0.0f));
    var _S64 : f32;
    if((n_2 * _S63) < 0.0f)
    {
        _S64 = - size_0;
    }
    else
    {
        _S64 = size_0;
    }
    var x_7 : f32 = clamp(_S64, seen_2.x_5.x, seen_2.x_5.y);
    var squared_1 : f32 = x_7 * x_7 + seen_2.z_1 * seen_2.z_1;
    var h_0 : vec2<f32> = seen_2.y_2 / sqrt(vec2<f32>(squared_1) + seen_2.y_2 * seen_2.y_2);
    var _S65 : f32 = h_0.x;
    var sine_2 : f32 = _S65 + u_1.y * (h_0.y - _S65);
    return vec2<f32>(x_7, clamp(sine_2 * sqrt(squared_1 / max((1.0f - sine_2) * (1.0f + sine_2), 0.0f)), _S60, _S62));
}

fn rectangle_face_0( at_13 : u32,  place_10 : vec2<f32>,  weights_1 : ptr<function, vec2<f32>>) -> u32
{
    var best_0 : f32 = -1.00000001504746622e+30f;
    var found_2 : u32 = u32(0);
    var face_0 : u32 = u32(0);
    for(;;)
    {
        if(face_0 < u32(2))
        {
        }
        else
        {
            break;
        }
        var row_1 : u32 = at_13 + u32(14) + u32(6) * face_0;
        var _S66 : f32 = place_10.x;
        var _S67 : f32 = place_10.y;
        var v_2 : f32 = number_0(row_1) + number_0(row_1 + u32(1)) * _S66 + number_0(row_1 + u32(2)) * _S67;
        var w_1 : f32 = number_0(row_1 + u32(3)) + number_0(row_1 + u32(4)) * _S66 + number_0(row_1 + u32(5)) * _S67;
        var _S68 : f32 = min(min(v_2, w_1), 1.0f - v_2 - w_1);
        if(_S68 > best_0)
        {
            (*weights_1)[i32(0)] = clamp(v_2, 0.0f, 1.0f);
            (*weights_1)[i32(1)] = clamp(w_1, 0.0f, 1.0f - (*weights_1).x);
            best_0 = _S68;
            found_2 = face_0;
        }
        face_0 = face_0 + u32(1);
    }
    return found_2;
}

fn emitter_triangle_0( record_4 : u32,  face_1 : u32) -> u32
{
    return word_0(word_0(u32(12)) + word_0(record_4 + u32(3)) + face_1);
}

fn precise_random_0( key_3 : vec2<u32>,  dimension_2 : u32) -> f32
{
    return f32(((random_bits_0(key_3, dimension_2).y) >> (u32(8)))) / 4096.0f / 4096.0f;
}

fn shares_of_0( nodes_at_0 : u32,  node_1 : u32,  viewpoint_2 : vec3<f32>) -> vec2<f32>
{
    var _S69 : f32 = node_seen_0(nodes_at_0 + u32(17) * word_0(node_1 + u32(2)), viewpoint_2);
    var _S70 : f32 = node_seen_0(nodes_at_0 + u32(17) * word_0(node_1 + u32(3)), viewpoint_2);
    var seen_3 : vec2<f32> = vec2<f32>(_S69, _S70);
    var sum_0 : f32 = _S69 + _S70;
    var _S71 : vec2<f32>;
    if(sum_0 > 0.0f)
    {
        _S71 = seen_3 / vec2<f32>(sum_0);
    }
    else
    {
        _S71 = vec2<f32>(0.0f);
    }
    return _S71;
}

struct Corners_0
{
     a_10 : vec3<f32>,
     b_8 : vec3<f32>,
     c_3 : vec3<f32>,
};

fn corners_from_0( record_5 : u32,  face_2 : u32,  viewpoint_3 : vec3<f32>) -> Corners_0
{
    var at_14 : u32 = u32(9) * emitter_triangle_0(record_5, face_2);
    var corners_0 : Corners_0;
    corners_0.a_10 = primitive_vector_0(at_14) - viewpoint_3;
    corners_0.b_8 = primitive_vector_0(at_14 + u32(3)) - viewpoint_3;
    corners_0.c_3 = primitive_vector_0(at_14 + u32(6)) - viewpoint_3;
    return corners_0;
}

fn face_solid_angle_0( record_6 : u32,  face_3 : u32,  viewpoint_4 : vec3<f32>) -> f32
{
    var corners_1 : Corners_0 = corners_from_0(record_6, face_3, viewpoint_4);
    return solid_angle_of_0(corners_1.a_10, corners_1.b_8, corners_1.c_3);
}

fn unit_across_0( v_3 : vec3<f32>,  axis_1 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_3 - axis_1 * vec3<f32>(dot(v_3, axis_1)));
}

fn along_0( from_0 : vec3<f32>,  to_0 : vec3<f32>,  cosine_3 : f32) -> vec3<f32>
{
    var _S72 : f32 = clamp(cosine_3, -1.0f, 1.0f);
    return from_0 * vec3<f32>(_S72) + unit_across_0(to_0, from_0) * vec3<f32>(sqrt((1.0f - _S72) * (1.0f + _S72)));
}

fn triangle_direction_0( a_11 : vec3<f32>,  b_9 : vec3<f32>,  c_4 : vec3<f32>,  area_1 : f32,  u_2 : vec2<f32>) -> vec3<f32>
{
    var _S73 : vec3<f32> = normalize(a_11);
    var _S74 : vec3<f32> = normalize(b_9);
    var _S75 : vec3<f32> = normalize(c_4);
    var ab_0 : vec3<f32> = normalize(cross(_S73, _S74));
    var ca_0 : vec3<f32> = normalize(cross(_S75, _S73));
    var sine_alpha_0 : f32 = length(cross(ab_0, ca_0));
    var cosine_alpha_0 : f32 = - dot(ab_0, ca_0);
    var part_0 : vec2<f32> = sine_cosine_0(u_2.x * area_1);
    var _S76 : f32 = part_0.x;
    var _S77 : f32 = part_0.y;
    var sine_phi_0 : f32 = _S76 * cosine_alpha_0 - _S77 * sine_alpha_0;
    var cosine_phi_0 : f32 = _S77 * cosine_alpha_0 + _S76 * sine_alpha_0;
    var k1_0 : f32 = cosine_phi_0 - cosine_alpha_0;
    var k2_0 : f32 = sine_phi_0 + sine_alpha_0 * dot(_S73, _S74);
    var between_0 : vec3<f32> = along_0(_S73, _S75, ((k2_0 * cosine_phi_0 - k1_0 * sine_phi_0) * cosine_alpha_0 - k2_0) / ((k2_0 * sine_phi_0 + k1_0 * cosine_phi_0) * sine_alpha_0));
    return along_0(_S74, between_0, 1.0f - u_2.y * (1.0f - dot(between_0, _S74)));
}

fn density_of_0( solid_angle_1 : f32,  normal_5 : vec3<f32>,  distance_2 : f32,  direction_2 : vec3<f32>) -> f32
{
    if(!(solid_angle_1 < 0.00100000004749745f))
    {
        return 1.0f;
    }
    return solid_angle_1 * 2.0f * distance_2 * distance_2 / abs(dot(normal_5, direction_2));
}

struct EmitterPoint_0
{
     place_11 : Place_0,
     pdf_0 : f32,
};

fn area_point_0( record_7 : u32,  from_1 : Surface_0,  key_4 : vec2<u32>,  dimension_3 : u32) -> EmitterPoint_0
{
    var total_0 : f32;
    var point_0 : EmitterPoint_0;
    point_0.pdf_0 = 0.0f;
    point_0.place_11.triangle_0 = u32(0);
    point_0.place_11.v_0 = 0.0f;
    point_0.place_11.w_0 = 0.0f;
    var second_1 : f32 = random_0(key_4, dimension_3 + u32(1));
    var rectangle_0 : u32 = word_0(record_7 + u32(4));
    if(rectangle_0 != u32(4294967295))
    {
        var seen_4 : SeenRectangle_0 = seen_rectangle_0(rectangle_0, from_1.position_0);
        if(!((seen_4.solid_angle_0) > 0.0f))
        {
            return point_0;
        }
        if((seen_4.solid_angle_0) >= 0.00100000004749745f)
        {
            var weights_2 : vec2<f32>;
            var face_4 : u32 = rectangle_face_0(rectangle_0, rectangle_place_0(seen_4, vec2<f32>(random_0(key_4, dimension_3), second_1)) - vec2<f32>(seen_4.x_5.x, seen_4.y_2.x), &(weights_2));
            point_0.place_11.triangle_0 = emitter_triangle_0(record_7, face_4);
            point_0.place_11.v_0 = weights_2.x;
            point_0.place_11.w_0 = weights_2.y;
            point_0.pdf_0 = 1.0f / seen_4.solid_angle_0;
            return point_0;
        }
    }
    var _S78 : f32 = precise_random_0(key_4, dimension_3);
    var nodes_at_1 : u32 = word_0(record_7 + u32(5));
    var node_2 : u32 = nodes_at_1;
    var u_3 : f32 = _S78;
    var chosen_0 : f32 = 1.0f;
    for(;;)
    {
        if((word_0(node_2 + u32(2))) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var shares_0 : vec2<f32> = shares_of_0(nodes_at_1, node_2, from_1.position_0);
        var _S79 : f32 = shares_0.x;
        var _S80 : f32 = shares_0.y;
        if(!((_S79 + _S80) > 0.0f))
        {
            return point_0;
        }
        var is_second_0 : bool;
        if(u_3 >= _S79)
        {
            is_second_0 = _S80 > 0.0f;
        }
        else
        {
            is_second_0 = false;
        }
        if(is_second_0)
        {
            u_3 = (u_3 - _S79) / _S80;
        }
        else
        {
            u_3 = min(u_3 / _S79, 1.0f);
        }
        if(is_second_0)
        {
            total_0 = _S80;
        }
        else
        {
            total_0 = _S79;
        }
        var chosen_1 : f32 = chosen_0 * total_0;
        var _S81 : i32;
        if(is_second_0)
        {
            _S81 = i32(3);
        }
        else
        {
            _S81 = i32(2);
        }
        node_2 = nodes_at_1 + u32(17) * word_0(node_2 + u32(_S81));
        chosen_0 = chosen_1;
    }
    var first_3 : u32 = word_0(node_2);
    var _S82 : u32 = word_0(node_2 + u32(1));
    var _S83 : u32 = word_0(record_7 + u32(6));
    var k_4 : u32 = first_3;
    total_0 = 0.0f;
    for(;;)
    {
        if(k_4 < _S82)
        {
        }
        else
        {
            break;
        }
        var total_1 : f32 = total_0 + face_solid_angle_0(record_7, word_0(_S83 + k_4), from_1.exact_0);
        k_4 = k_4 + u32(1);
        total_0 = total_1;
    }
    var _S84 : f32 = u_3 * total_0;
    var face_5 : u32 = u32(4294967295);
    var angle_3 : f32 = 0.0f;
    var inside_2 : f32 = 0.0f;
    k_4 = first_3;
    var rest_3 : f32 = _S84;
    for(;;)
    {
        if(k_4 < _S82)
        {
        }
        else
        {
            break;
        }
        var _S85 : u32 = _S83 + k_4;
        var own_1 : f32 = face_solid_angle_0(record_7, word_0(_S85), from_1.exact_0);
        if(!(own_1 > 0.0f))
        {
            k_4 = k_4 + u32(1);
            continue;
        }
        var _S86 : u32 = word_0(_S85);
        var _S87 : f32 = min(rest_3 / own_1, 1.0f);
        if(rest_3 < own_1)
        {
            face_5 = _S86;
            angle_3 = own_1;
            inside_2 = _S87;
            break;
        }
        var rest_4 : f32 = rest_3 - own_1;
        face_5 = _S86;
        angle_3 = own_1;
        inside_2 = _S87;
        rest_3 = rest_4;
        k_4 = k_4 + u32(1);
    }
    if(face_5 == u32(4294967295))
    {
        return point_0;
    }
    var corners_2 : Corners_0 = corners_from_0(record_7, face_5, from_1.exact_0);
    var ab_1 : vec3<f32> = corners_2.b_8 - corners_2.a_10;
    var ac_0 : vec3<f32> = corners_2.c_3 - corners_2.a_10;
    var normal_6 : vec3<f32> = cross(ab_1, ac_0);
    point_0.place_11.triangle_0 = emitter_triangle_0(record_7, face_5);
    if(angle_3 < 0.00100000004749745f)
    {
        var root_0 : f32 = sqrt(inside_2);
        point_0.place_11.v_0 = root_0 * (1.0f - second_1);
        point_0.place_11.w_0 = root_0 * second_1;
    }
    else
    {
        var direction_3 : vec3<f32> = triangle_direction_0(corners_2.a_10, corners_2.b_8, corners_2.c_3, angle_3, vec2<f32>(inside_2, second_1));
        var within_0 : vec3<f32> = direction_3 * vec3<f32>((dot(corners_2.a_10, normal_6) / dot(direction_3, normal_6))) - corners_2.a_10;
        var squared_2 : f32 = dot(normal_6, normal_6);
        var _S88 : f32 = clamp(dot(cross(within_0, ac_0), normal_6) / squared_2, 0.0f, 1.0f);
        point_0.place_11.v_0 = _S88;
        point_0.place_11.w_0 = clamp(dot(cross(ab_1, within_0), normal_6) / squared_2, 0.0f, 1.0f - _S88);
    }
    var offset_3 : vec3<f32> = corners_2.a_10 + ab_1 * vec3<f32>(point_0.place_11.v_0) + ac_0 * vec3<f32>(point_0.place_11.w_0);
    var distance_3 : f32 = length(offset_3);
    if(!(distance_3 > 0.0f))
    {
        return point_0;
    }
    point_0.pdf_0 = chosen_0 / total_0 * density_of_0(angle_3, normal_6, distance_3, offset_3 / vec3<f32>(distance_3));
    return point_0;
}

fn random_pair_0( key_5 : vec2<u32>,  dimension_4 : u32) -> vec2<f32>
{
    return vec2<f32>(random_0(key_5, dimension_4), random_0(key_5, dimension_4 + u32(1)));
}

fn sample_cosine_0( axes_1 : Axes_0,  u_4 : vec2<f32>) -> vec3<f32>
{
    var _S89 : f32 = u_4.x;
    var turn_1 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_4.y) * vec2<f32>(sqrt(_S89));
    return normalize(axes_1.s_0 * vec3<f32>(turn_1.y) + axes_1.t_0 * vec3<f32>(turn_1.x) + axes_1.n_1 * vec3<f32>(sqrt(1.0f - _S89)));
}

fn cosine_pdf_0( axes_2 : Axes_0,  direction_4 : vec3<f32>) -> f32
{
    return max(dot(axes_2.n_1, direction_4), 0.0f) * 0.31830987334251404f;
}

fn component_0( v_4 : vec3<f32>,  axis_2 : u32) -> f32
{
    var _S90 : f32;
    if(axis_2 == u32(0))
    {
        _S90 = v_4.x;
    }
    else
    {
        if(axis_2 == u32(1))
        {
            _S90 = v_4.y;
        }
        else
        {
            _S90 = v_4.z;
        }
    }
    return _S90;
}

fn ray_child_0( node_3 : u32,  slot_1 : u32) -> u32
{
    return nodes_0[u32(14) * node_3 + u32(12) + slot_1 / u32(4)][slot_1 % u32(4)];
}

struct RayView_0
{
     inverse_0 : vec3<f32>,
     offset_near_0 : vec3<f32>,
     offset_far_0 : vec3<f32>,
     limit_0 : f32,
     margin_0 : f32,
     axes_3 : u32,
};

fn ray_bound_0( view_2 : RayView_0,  limit_1 : f32,  node_4 : u32,  slot_2 : u32) -> f32
{
    var _S91 : u32 = u32(14) * node_4 + slot_2 / u32(4);
    var near_0 : f32 = 0.0f;
    var far_0 : f32 = limit_1;
    var axis_3 : u32 = u32(0);
    for(;;)
    {
        if(axis_3 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S92 : u32 = axis_3;
        var _S93 : u32 = _S91 + u32(2) * axis_3;
        var _S94 : u32 = slot_2 % u32(4);
        var low_3 : f32 = (bitcast<f32>((nodes_0[_S93][_S94])));
        var high_0 : f32 = (bitcast<f32>((nodes_0[_S93 + u32(6)][_S94])));
        var _S95 : bool = (view_2.inverse_0[axis_3]) < 0.0f;
        var _S96 : f32;
        if(_S95)
        {
            _S96 = high_0;
        }
        else
        {
            _S96 = low_3;
        }
        var _S97 : f32 = max(near_0, _S96 * view_2.inverse_0[_S92] - view_2.offset_near_0[axis_3]);
        var _S98 : f32;
        if(_S95)
        {
            _S98 = low_3;
        }
        else
        {
            _S98 = high_0;
        }
        var _S99 : f32 = min(far_0, _S98 * view_2.inverse_0[_S92] - view_2.offset_far_0[axis_3]);
        var _S100 : u32 = axis_3 + u32(1);
        near_0 = _S97;
        far_0 = _S99;
        axis_3 = _S100;
    }
    if(near_0 <= far_0)
    {
    }
    else
    {
        near_0 = 3.00000000549775576e+38f;
    }
    return near_0;
}

fn nearest_first_0( bounds_0 : array<f32, i32(8)>,  limit_2 : f32) -> u32
{
    var k_5 : u32 = u32(0);
    var order_0 : u32 = u32(0);
    for(;;)
    {
        if(k_5 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S101 : u32 = k_5;
        if((bounds_0[k_5]) > limit_2)
        {
            k_5 = k_5 + u32(1);
            continue;
        }
        var j_0 : u32 = u32(0);
        var rank_0 : u32 = u32(0);
        for(;;)
        {
            if(j_0 < u32(8))
            {
            }
            else
            {
                break;
            }
            var _S102 : u32 = j_0;
            var _S103 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S101]))
            {
                _S103 = true;
            }
            else
            {
                if((bounds_0[_S102]) == (bounds_0[_S101]))
                {
                    _S103 = j_0 < k_5;
                }
                else
                {
                    _S103 = false;
                }
            }
            if(_S103)
            {
                rank_0 = rank_0 + u32(1);
            }
            j_0 = j_0 + u32(1);
        }
        order_0 = (order_0 | ((((k_5 + u32(1)) << ((u32(4) * rank_0))))));
        k_5 = k_5 + u32(1);
    }
    return order_0;
}

fn crossed_0( view_3 : RayView_0,  limit_3 : f32,  node_5 : u32) -> u32
{
    var bounds_1 : array<f32, i32(8)>;
    var slot_3 : u32 = u32(0);
    for(;;)
    {
        if(slot_3 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S104 : f32;
        if((ray_child_0(node_5, slot_3)) == u32(4294967295))
        {
            _S104 = 3.00000000549775576e+38f;
        }
        else
        {
            _S104 = ray_bound_0(view_3, limit_3, node_5, slot_3);
        }
        bounds_1[slot_3] = _S104;
        slot_3 = slot_3 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn rounded_0( product_1 : f32,  largest_0 : f32) -> f32
{
    return min(product_1, largest_0);
}

struct Ray_0
{
     origin_0 : vec3<f32>,
     shear_x_0 : f32,
     shear_y_0 : f32,
     inverse_z_0 : f32,
     t_min_0 : f32,
     t_max_0 : f32,
     local_per_t_0 : f32,
     enter_0 : f32,
     edge_on_0 : f32,
     largest_1 : f32,
};

fn corner_0( ray_0 : Ray_0,  axes_4 : u32,  at_15 : u32) -> vec3<f32>
{
    var relative_0 : vec3<f32> = primitive_vector_0(at_15) - ray_0.origin_0;
    var z_3 : f32 = component_0(relative_0, (axes_4 >> (u32(4))));
    return vec3<f32>(component_0(relative_0, (axes_4 & (u32(3)))) - rounded_0(ray_0.shear_x_0 * z_3, ray_0.largest_1), component_0(relative_0, (((axes_4 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_0.shear_y_0 * z_3, ray_0.largest_1), z_3);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_2 : f32,
     v_5 : f32,
     w_2 : f32,
};

fn intersect_0( ray_1 : Ray_0,  axes_5 : u32,  at_16 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_2 = 0.0f;
    crossing_0.v_5 = 0.0f;
    crossing_0.w_2 = 0.0f;
    var a_12 : vec3<f32> = corner_0(ray_1, axes_5, at_16);
    var b_10 : vec3<f32> = corner_0(ray_1, axes_5, at_16 + u32(3));
    var c_5 : vec3<f32> = corner_0(ray_1, axes_5, at_16 + u32(6));
    var _S105 : f32 = c_5.x;
    var _S106 : f32 = b_10.y;
    var cx_by_0 : f32 = rounded_0(_S105 * _S106, ray_1.largest_1);
    var _S107 : f32 = c_5.y;
    var _S108 : f32 = b_10.x;
    var cy_bx_0 : f32 = rounded_0(_S107 * _S108, ray_1.largest_1);
    var _S109 : f32 = a_12.x;
    var ax_cy_0 : f32 = rounded_0(_S109 * _S107, ray_1.largest_1);
    var _S110 : f32 = a_12.y;
    var ay_cx_0 : f32 = rounded_0(_S110 * _S105, ray_1.largest_1);
    var bx_ay_0 : f32 = rounded_0(_S108 * _S110, ray_1.largest_1);
    var by_ax_0 : f32 = rounded_0(_S106 * _S109, ray_1.largest_1);
    var u_5 : f32 = cx_by_0 - cy_bx_0;
    var v_6 : f32 = ax_cy_0 - ay_cx_0;
    var w_3 : f32 = bx_ay_0 - by_ax_0;
    var _S111 : f32 = min(min(u_5, v_6), w_3);
    var _S112 : f32 = max(max(u_5, v_6), w_3);
    var _S113 : bool;
    if(_S111 < 0.0f)
    {
        _S113 = _S112 > 0.0f;
    }
    else
    {
        _S113 = false;
    }
    if(_S113)
    {
        return crossing_0;
    }
    var determinant_0 : f32 = u_5 + v_6 + w_3;
    if(_S111 <= 0.0f)
    {
        _S113 = _S112 >= 0.0f;
    }
    else
    {
        _S113 = false;
    }
    if(_S113)
    {
        if((abs(determinant_0)) <= (ray_1.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0f)
    {
        return crossing_0;
    }
    var t_3 : f32 = (rounded_0(u_5 * a_12.z, ray_1.largest_1) + rounded_0(v_6 * b_10.z, ray_1.largest_1) + rounded_0(w_3 * c_5.z, ray_1.largest_1)) / determinant_0 * ray_1.inverse_z_0;
    if((ray_1.t_min_0) <= t_3)
    {
        _S113 = t_3 <= (ray_1.t_max_0);
    }
    else
    {
        _S113 = false;
    }
    crossing_0.is_hit_0 = _S113;
    crossing_0.t_2 = t_3;
    crossing_0.v_5 = v_6 / determinant_0;
    crossing_0.w_2 = w_3 / determinant_0;
    return crossing_0;
}

fn face_6( triangle_4 : u32) -> u32
{
    return rough_0[triangle_4 / u32(4)][triangle_4 % u32(4)];
}

struct Found_0
{
     face_7 : u32,
     triangle_5 : u32,
     v_7 : f32,
     w_4 : f32,
};

fn first_found_0( view_4 : RayView_0,  ray_2 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S114 : bool;
    var found_3 : Found_0;
    found_3.face_7 = u32(4294967295);
    found_3.triangle_5 = u32(4294967295);
    found_3.v_7 = 0.0f;
    found_3.w_4 = 0.0f;
    if(!((view_4.limit_0) >= 0.0f))
    {
        return found_3;
    }
    var way_1 : array<vec2<u32>, i32(40)>;
    way_1[i32(0)] = vec2<u32>(u32(0), u32(0));
    var entered_0 : u32 = u32(0);
    var limit_4 : f32 = view_4.limit_0;
    var is_new_0 : bool = true;
    var level_0 : u32 = u32(0);
    for(;;)
    {
        var entered_1 : u32;
        var is_new_1 : bool;
        if(entered_0 != u32(4294967295))
        {
            way_1[level_0] = vec2<u32>(entered_0, crossed_0(view_4, limit_4, entered_0));
            is_new_1 = true;
            entered_1 = u32(4294967295);
        }
        else
        {
            is_new_1 = is_new_0;
            entered_1 = entered_0;
        }
        var here_0 : vec2<u32> = way_1[level_0];
        var _S115 : u32 = way_1[level_0].y;
        if(_S115 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S116 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S116;
            continue;
        }
        var slot_4 : u32 = ((_S115 & (u32(15)))) - u32(1);
        way_1[level_0][i32(1)] = (_S115 >> (u32(4)));
        var _S117 : bool;
        if(!is_new_1)
        {
            _S117 = (ray_bound_0(view_4, limit_4, here_0.x, slot_4)) > limit_4;
        }
        else
        {
            _S117 = false;
        }
        if(_S117)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_0.x, slot_4);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S118 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S118;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S119 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S120 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_3 : u32 = _S120;
        for(;;)
        {
            if(i_3 < _S119)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_2), view_4.axes_3, u32(9) * i_3);
            if(!crossing_1.is_hit_0)
            {
                i_3 = i_3 + u32(1);
                continue;
            }
            if((found_3.face_7) == u32(4294967295))
            {
                _S114 = true;
            }
            else
            {
                _S114 = (crossing_1.t_2) < ((*ray_2).t_max_0);
            }
            var _S121 : bool;
            if(_S114)
            {
                _S121 = true;
            }
            else
            {
                _S121 = (face_6(i_3)) < (found_3.face_7);
            }
            var limit_6 : f32;
            if(_S121)
            {
                found_3.face_7 = face_6(i_3);
                found_3.triangle_5 = i_3;
                (*ray_2).t_max_0 = crossing_1.t_2;
                found_3.v_7 = crossing_1.v_5;
                found_3.w_4 = crossing_1.w_2;
                limit_6 = min(limit_5, crossing_1.t_2 * (*ray_2).local_per_t_0 - (*ray_2).enter_0 + 2.0f * view_4.margin_0);
            }
            else
            {
                limit_6 = limit_5;
            }
            limit_5 = limit_6;
            i_3 = i_3 + u32(1);
        }
        if(any_0)
        {
            _S114 = (found_3.face_7) != u32(4294967295);
        }
        else
        {
            _S114 = false;
        }
        if(_S114)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_3;
}

fn cast_0( origin_1 : vec3<f32>,  direction_5 : vec3<f32>,  t_min_1 : f32,  t_max_1 : f32,  any_1 : bool,  t_4 : ptr<function, f32>) -> Found_0
{
    var size_1 : vec3<f32> = abs(direction_5);
    var _S122 : f32 = size_1.x;
    var _S123 : f32 = size_1.y;
    var _S124 : bool;
    if(_S122 >= _S123)
    {
        _S124 = _S122 >= (size_1.z);
    }
    else
    {
        _S124 = false;
    }
    var _S125 : i32;
    if(_S124)
    {
        _S125 = i32(0);
    }
    else
    {
        if(_S123 >= (size_1.z))
        {
            _S125 = i32(1);
        }
        else
        {
            _S125 = i32(2);
        }
    }
    var z_4 : u32 = u32(_S125);
    var x_8 : u32 = (z_4 + u32(1)) % u32(3);
    var y_3 : u32 = (z_4 + u32(2)) % u32(3);
    var ray_3 : Ray_0;
    ray_3.origin_0 = origin_1;
    var along_1 : f32 = component_0(direction_5, z_4);
    ray_3.inverse_z_0 = 1.0f / along_1;
    ray_3.shear_x_0 = component_0(direction_5, x_8) / along_1;
    ray_3.shear_y_0 = component_0(direction_5, y_3) / along_1;
    ray_3.t_min_0 = t_min_1;
    ray_3.t_max_0 = t_max_1;
    var _S126 : f32 = abs(along_1);
    ray_3.local_per_t_0 = _S126;
    ray_3.enter_0 = 0.0f;
    ray_3.edge_on_0 = limit_at_0(u32(0));
    ray_3.largest_1 = limit_at_0(u32(1));
    var view_5 : RayView_0;
    var _S127 : vec3<f32> = direction_5 / vec3<f32>(_S126);
    var axis_4 : u32 = u32(0);
    for(;;)
    {
        if(axis_4 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S128 : f32 = max(abs(_S127[axis_4]), 8.67361737988403547e-19f);
        var _S129 : f32;
        if((_S127[axis_4]) < 0.0f)
        {
            _S129 = -1.0f / _S128;
        }
        else
        {
            _S129 = 1.0f / _S128;
        }
        view_5.inverse_0[axis_4] = _S129;
        axis_4 = axis_4 + u32(1);
    }
    var offset_4 : vec3<f32> = origin_1 * view_5.inverse_0;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_5.inverse_0);
    view_5.offset_near_0 = offset_4 + wider_0;
    view_5.offset_far_0 = offset_4 - wider_0;
    view_5.limit_0 = min(t_max_1 * ray_3.local_per_t_0, 8.0f) + 3.814697265625e-06f;
    view_5.margin_0 = 3.814697265625e-06f;
    view_5.axes_3 = (((x_8 | (((y_3 << (u32(2))))))) | (((z_4 << (u32(4))))));
    var found_4 : Found_0 = first_found_0(view_5, &(ray_3), any_1);
    (*t_4) = ray_3.t_max_0;
    return found_4;
}

fn cast_1( origin_2 : vec3<f32>,  direction_6 : vec3<f32>,  t_min_2 : f32,  t_max_2 : f32,  any_2 : bool,  t_5 : ptr<function, f32>) -> Found_0
{
    var size_2 : vec3<f32> = abs(direction_6);
    var _S130 : f32 = size_2.x;
    var _S131 : f32 = size_2.y;
    var _S132 : bool;
    if(_S130 >= _S131)
    {
        _S132 = _S130 >= (size_2.z);
    }
    else
    {
        _S132 = false;
    }
    var _S133 : i32;
    if(_S132)
    {
        _S133 = i32(0);
    }
    else
    {
        if(_S131 >= (size_2.z))
        {
            _S133 = i32(1);
        }
        else
        {
            _S133 = i32(2);
        }
    }
    var z_5 : u32 = u32(_S133);
    var x_9 : u32 = (z_5 + u32(1)) % u32(3);
    var y_4 : u32 = (z_5 + u32(2)) % u32(3);
    var ray_4 : Ray_0;
    ray_4.origin_0 = origin_2;
    var along_2 : f32 = component_0(direction_6, z_5);
    ray_4.inverse_z_0 = 1.0f / along_2;
    ray_4.shear_x_0 = component_0(direction_6, x_9) / along_2;
    ray_4.shear_y_0 = component_0(direction_6, y_4) / along_2;
    ray_4.t_min_0 = t_min_2;
    ray_4.t_max_0 = t_max_2;
    var _S134 : f32 = abs(along_2);
    ray_4.local_per_t_0 = _S134;
    ray_4.enter_0 = 0.0f;
    ray_4.edge_on_0 = limit_at_0(u32(0));
    ray_4.largest_1 = limit_at_0(u32(1));
    var view_6 : RayView_0;
    var _S135 : vec3<f32> = direction_6 / vec3<f32>(_S134);
    var axis_5 : u32 = u32(0);
    for(;;)
    {
        if(axis_5 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S136 : f32 = max(abs(_S135[axis_5]), 8.67361737988403547e-19f);
        var _S137 : f32;
        if((_S135[axis_5]) < 0.0f)
        {
            _S137 = -1.0f / _S136;
        }
        else
        {
            _S137 = 1.0f / _S136;
        }
        view_6.inverse_0[axis_5] = _S137;
        axis_5 = axis_5 + u32(1);
    }
    var offset_5 : vec3<f32> = origin_2 * view_6.inverse_0;
    var wider_1 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_6.inverse_0);
    view_6.offset_near_0 = offset_5 + wider_1;
    view_6.offset_far_0 = offset_5 - wider_1;
    view_6.limit_0 = min(t_max_2 * ray_4.local_per_t_0, 8.0f) + 3.814697265625e-06f;
    view_6.margin_0 = 3.814697265625e-06f;
    view_6.axes_3 = (((x_9 | (((y_4 << (u32(2))))))) | (((z_5 << (u32(4))))));
    var found_5 : Found_0 = first_found_0(view_6, &(ray_4), any_2);
    (*t_5) = ray_4.t_max_0;
    return found_5;
}

fn weight_over_0( own_2 : f32,  other_0 : f32) -> f32
{
    var ratio_0 : f32 = other_0 / own_2;
    if(ratio_0 > 9.9999998430674944e+17f)
    {
        return 0.0f;
    }
    return 1.0f / (own_2 * (1.0f + ratio_0 * ratio_0));
}

fn x2A_0( a_13 : Colour_0,  b_11 : f32) -> Colour_0
{
    var product_2 : Colour_0;
    var _S138 : vec3<f32> = vec3<f32>(b_11);
    product_2.value_0 = a_13.value_0 * _S138;
    var k_6 : u32 = u32(0);
    for(;;)
    {
        if(k_6 < u32(1))
        {
        }
        else
        {
            break;
        }
        product_2.changes_0[k_6] = a_13.changes_0[k_6] * _S138;
        k_6 = k_6 + u32(1);
    }
    return product_2;
}

fn x2A_1( a_14 : Colour_0,  b_12 : Colour_0) -> Colour_0
{
    var product_3 : Colour_0;
    product_3.value_0 = a_14.value_0 * b_12.value_0;
    var k_7 : u32 = u32(0);
    for(;;)
    {
        if(k_7 < u32(1))
        {
        }
        else
        {
            break;
        }
        product_3.changes_0[k_7] = a_14.changes_0[k_7] * b_12.value_0 + a_14.value_0 * b_12.changes_0[k_7];
        k_7 = k_7 + u32(1);
    }
    return product_3;
}

fn arriving_0( emitter_5 : u32,  place_12 : Place_0,  factor_0 : Colour_0,  importance_0 : vec3<f32>) -> Colour_0
{
    var _S139 : Colour_0 = colour_at_0(word_0(emitter_record_0(emitter_5) + u32(1)), place_12, u32(0));
    return x2A_1(factor_0, _S139);
}

fn light_from_emitter_0( surface_2 : Surface_0,  axes_6 : Axes_0,  reflectance_0 : Colour_0,  choice_5 : Choice_0,  key_6 : vec2<u32>,  first_4 : u32,  bsdf_samples_0 : f32,  importance_1 : vec3<f32>) -> Colour_0
{
    var none_0 : Colour_0 = constant_0(vec3<f32>(0.0f));
    var probability_1 : f32;
    var emitter_6 : u32 = chosen_emitter_0(choice_5, random_0(key_6, first_4), &(probability_1));
    if(probability_1 == 0.0f)
    {
        return none_0;
    }
    var record_8 : u32 = emitter_record_0(emitter_6);
    var point_1 : EmitterPoint_0;
    var nearest_0 : f32 = limit_at_0(u32(2));
    var way_2 : vec3<f32>;
    var direction_7 : vec3<f32>;
    var farthest_0 : f32;
    var nearest_1 : f32;
    if((word_0(record_8)) != u32(0))
    {
        point_1 = area_point_0(record_8, surface_2, key_6, first_4 + u32(1));
        if(!((point_1.pdf_0) > 0.0f))
        {
            return none_0;
        }
        var way_3 : vec3<f32> = position_of_0(point_1.place_11) - surface_2.exact_0;
        var distance_4 : f32 = length(way_3);
        var direction_8 : vec3<f32> = way_3 / vec3<f32>(distance_4);
        if((dot(direction_8, axes_6.n_1)) <= 0.0f)
        {
            return none_0;
        }
        var nearest_2 : f32 = nearest_0 / distance_4;
        var _S140 : f32 = limit_at_0(u32(3));
        way_2 = way_3;
        farthest_0 = _S140;
        direction_7 = direction_8;
        nearest_1 = nearest_2;
    }
    else
    {
        var direction_9 : vec3<f32> = sample_cosine_0(axes_6, random_pair_0(key_6, first_4 + u32(1)));
        point_1.pdf_0 = cosine_pdf_0(axes_6, direction_9);
        point_1.place_11 = surface_2.place_3;
        var _S141 : f32 = limit_at_0(u32(1));
        way_2 = direction_9;
        farthest_0 = _S141;
        direction_7 = direction_9;
        nearest_1 = nearest_0;
    }
    var unused_0 : f32;
    if((cast_0(surface_2.exact_0, way_2, nearest_1, farthest_0, true, &(unused_0)).face_7) != u32(4294967295))
    {
        return none_0;
    }
    var own_3 : f32 = f32(word_0(u32(2))) * probability_1 * point_1.pdf_0;
    var pdf_1 : f32 = cosine_pdf_0(axes_6, direction_7);
    if(!(own_3 > 0.0f))
    {
        return none_0;
    }
    var _S142 : Colour_0 = arriving_0(emitter_6, point_1.place_11, x2A_0(reflectance_0, pdf_1 * weight_over_0(own_3, bsdf_samples_0 * pdf_1)), importance_1);
    return _S142;
}

fn x2B_0( a_15 : Colour_0,  b_13 : Colour_0) -> Colour_0
{
    var sum_1 : Colour_0;
    sum_1.value_0 = a_15.value_0 + b_13.value_0;
    var k_8 : u32 = u32(0);
    for(;;)
    {
        if(k_8 < u32(1))
        {
        }
        else
        {
            break;
        }
        sum_1.changes_0[k_8] = a_15.changes_0[k_8] + b_13.changes_0[k_8];
        k_8 = k_8 + u32(1);
    }
    return sum_1;
}

fn first_from_0( position_6 : vec3<f32>,  direction_10 : vec3<f32>,  t_6 : ptr<function, f32>) -> Found_0
{
    var _S143 : Found_0 = cast_1(position_6, direction_10, limit_at_0(u32(2)), limit_at_0(u32(1)), false, &((*t_6)));
    return _S143;
}

fn place_of_0( found_6 : Found_0) -> Place_0
{
    var place_13 : Place_0;
    place_13.triangle_0 = found_6.triangle_5;
    place_13.v_0 = found_6.v_7;
    place_13.w_0 = found_6.w_4;
    return place_13;
}

fn emitter_seen_0( found_7 : Found_0,  direction_11 : vec3<f32>) -> u32
{
    if((found_7.face_7) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_7 : u32 = word_0(shape_of_0(found_7.triangle_5) + u32(4));
    var _S144 : bool;
    if(emitter_7 != u32(4294967295))
    {
        _S144 = (dot(cross_of_0(found_7.triangle_5), direction_11)) < 0.0f;
    }
    else
    {
        _S144 = false;
    }
    var _S145 : u32;
    if(_S144)
    {
        _S145 = emitter_7;
    }
    else
    {
        _S145 = u32(4294967295);
    }
    return _S145;
}

fn area_pdf_0( record_9 : u32,  face_8 : u32,  from_2 : Surface_0,  direction_12 : vec3<f32>,  distance_5 : f32) -> f32
{
    var own_4 : f32;
    var rectangle_1 : u32 = word_0(record_9 + u32(4));
    if(rectangle_1 != u32(4294967295))
    {
        var _S146 : SeenRectangle_0 = seen_rectangle_0(rectangle_1, from_2.position_0);
        if(!((_S146.solid_angle_0) > 0.0f))
        {
            return 0.0f;
        }
        if((_S146.solid_angle_0) >= 0.00100000004749745f)
        {
            return 1.0f / _S146.solid_angle_0;
        }
    }
    var _S147 : u32 = word_0(word_0(record_9 + u32(7)) + face_8);
    var nodes_at_2 : u32 = word_0(record_9 + u32(5));
    var node_6 : u32 = nodes_at_2;
    var chosen_2 : f32 = 1.0f;
    for(;;)
    {
        if((word_0(node_6 + u32(2))) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var shares_1 : vec2<f32> = shares_of_0(nodes_at_2, node_6, from_2.position_0);
        var is_second_1 : bool = _S147 >= (word_0(nodes_at_2 + u32(17) * word_0(node_6 + u32(3))));
        if(is_second_1)
        {
            own_4 = shares_1.y;
        }
        else
        {
            own_4 = shares_1.x;
        }
        var chosen_3 : f32 = chosen_2 * own_4;
        var _S148 : i32;
        if(is_second_1)
        {
            _S148 = i32(3);
        }
        else
        {
            _S148 = i32(2);
        }
        node_6 = nodes_at_2 + u32(17) * word_0(node_6 + u32(_S148));
        chosen_2 = chosen_3;
    }
    var _S149 : u32 = word_0(record_9 + u32(6));
    var _S150 : u32 = word_0(node_6);
    own_4 = 0.0f;
    var k_9 : u32 = _S150;
    var total_2 : f32 = 0.0f;
    for(;;)
    {
        if(k_9 < (word_0(node_6 + u32(1))))
        {
        }
        else
        {
            break;
        }
        var angle_4 : f32 = face_solid_angle_0(record_9, word_0(_S149 + k_9), from_2.exact_0);
        var total_3 : f32 = total_2 + angle_4;
        if(k_9 == _S147)
        {
            own_4 = angle_4;
        }
        k_9 = k_9 + u32(1);
        total_2 = total_3;
    }
    if(!(own_4 > 0.0f))
    {
        return 0.0f;
    }
    return chosen_2 / total_2 * density_of_0(own_4, cross_of_0(emitter_triangle_0(record_9, face_8)), distance_5, direction_12);
}

fn emitter_pdf_0( emitter_8 : u32,  found_8 : Found_0,  surface_3 : Surface_0,  axes_7 : Axes_0,  direction_13 : vec3<f32>,  t_7 : f32) -> f32
{
    var record_10 : u32 = emitter_record_0(emitter_8);
    if((word_0(record_10)) == u32(0))
    {
        return cosine_pdf_0(axes_7, direction_13);
    }
    return area_pdf_0(record_10, found_8.face_7 - word_0(record_10 + u32(3)), surface_3, direction_13, t_7);
}

fn value_of_0( colour_3 : Colour_0) -> vec3<f32>
{
    return colour_3.value_0;
}

fn take_further_0( path_6 : ptr<function, Path_0>,  vertex_1 : ptr<function, Vertex_0>,  importance_2 : vec3<f32>) -> bool
{
    var depth_2 : u32 = launch_0.depth_0;
    var first_5 : u32 = vertex_numbers_0(launch_0.depth_0);
    var surface_4 : Surface_0 = surface_at_0((*path_6).place_1, (*path_6).direction_0);
    var _S151 : i32;
    if(surface_4.is_front_0)
    {
        _S151 = i32(2);
    }
    else
    {
        _S151 = i32(3);
    }
    var texture_5 : u32 = word_0(surface_4.shape_0 + u32(_S151));
    if(texture_5 == u32(4294967295))
    {
        return false;
    }
    (*vertex_1).textures_0[i32(0)] = texture_5;
    var reflectance_1 : Colour_0 = colour_at_0(texture_5, (*path_6).place_1, u32(0));
    var axes_8 : Axes_0 = axes_at_0(surface_4);
    var emitter_samples_0 : u32 = word_0(u32(2));
    var _S152 : u32 = word_0(u32(3));
    var _S153 : bool = !reaches_0(depth_2 + u32(3));
    var goes_on_0 : bool;
    if(_S153)
    {
        goes_on_0 = is_sampled_well_0(surface_4.position_0);
    }
    else
    {
        goes_on_0 = false;
    }
    var bsdf_samples_1 : u32;
    if(goes_on_0)
    {
        bsdf_samples_1 = u32(0);
    }
    else
    {
        bsdf_samples_1 = _S152;
    }
    var _S154 : Choice_0 = choice_at_0(surface_4.position_0, axes_8.n_1);
    var i_4 : u32 = u32(0);
    for(;;)
    {
        if(i_4 < emitter_samples_0)
        {
        }
        else
        {
            break;
        }
        var _S155 : Colour_0 = light_from_emitter_0(surface_4, axes_8, reflectance_1, _S154, (*path_6).key_0, first_5 + u32(3) * i_4, f32(bsdf_samples_1), importance_2);
        (*vertex_1).direct_0 = x2B_0((*vertex_1).direct_0, _S155);
        i_4 = i_4 + u32(1);
    }
    var first_6 : u32 = first_5 + u32(3) * emitter_samples_0;
    goes_on_0 = false;
    var next_0 : Place_0 = (*path_6).place_1;
    var next_direction_0 : vec3<f32> = (*path_6).direction_0;
    var k_10 : u32 = u32(0);
    for(;;)
    {
        if(k_10 < bsdf_samples_1)
        {
        }
        else
        {
            break;
        }
        var direction_14 : vec3<f32> = sample_cosine_0(axes_8, random_pair_0((*path_6).key_0, first_6 + u32(3) * k_10 + u32(1)));
        var pdf_2 : f32 = cosine_pdf_0(axes_8, direction_14);
        if(!(pdf_2 > 0.0f))
        {
            k_10 = k_10 + u32(1);
            continue;
        }
        var t_8 : f32;
        var found_9 : Found_0 = first_from_0(surface_4.exact_0, direction_14, &(t_8));
        var goes_on_1 : bool;
        var next_1 : Place_0;
        var next_direction_1 : vec3<f32>;
        if(k_10 == u32(0))
        {
            var _S156 : Place_0 = place_of_0(found_9);
            goes_on_1 = (found_9.face_7) != u32(4294967295);
            next_1 = _S156;
            next_direction_1 = direction_14;
        }
        else
        {
            goes_on_1 = goes_on_0;
            next_1 = next_0;
            next_direction_1 = next_direction_0;
        }
        var emitter_9 : u32 = emitter_seen_0(found_9, direction_14);
        if(emitter_9 == u32(4294967295))
        {
            goes_on_0 = goes_on_1;
            next_0 = next_1;
            next_direction_0 = next_direction_1;
            k_10 = k_10 + u32(1);
            continue;
        }
        var own_5 : f32 = f32(bsdf_samples_1) * pdf_2;
        var other_1 : f32;
        if(emitter_samples_0 == u32(0))
        {
            other_1 = 0.0f;
        }
        else
        {
            other_1 = f32(emitter_samples_0) * chance_of_0(emitter_9, _S154) * emitter_pdf_0(emitter_9, found_9, surface_4, axes_8, direction_14, t_8);
        }
        var _S157 : Colour_0 = arriving_0(emitter_9, place_of_0(found_9), x2A_0(reflectance_1, pdf_2 * weight_over_0(own_5, other_1)), importance_2);
        (*vertex_1).direct_0 = x2B_0((*vertex_1).direct_0, _S157);
        goes_on_0 = goes_on_1;
        next_0 = next_1;
        next_direction_0 = next_direction_1;
        k_10 = k_10 + u32(1);
    }
    if(_S153)
    {
        goes_on_0 = true;
    }
    else
    {
        goes_on_0 = !goes_on_0;
    }
    if(goes_on_0)
    {
        return false;
    }
    (*vertex_1).onward_0 = reflectance_1;
    var throughput_1 : vec3<f32> = value_of_0((*path_6).throughput_0) * value_of_0(reflectance_1);
    var _S158 : f32 = max(max(throughput_1.x, throughput_1.y), throughput_1.z);
    var _S159 : u32 = depth_2 + u32(1);
    if(_S159 >= (word_0(u32(1))))
    {
        var survival_0 : f32 = clamp(_S158, 0.05000000074505806f, 0.94999998807907104f);
        if((random_0((*path_6).key_0, vertex_numbers_0(_S159) - u32(1))) >= survival_0)
        {
            return false;
        }
        (*vertex_1).onward_0 = x2A_0((*vertex_1).onward_0, 1.0f / survival_0);
    }
    (*path_6).place_1 = next_0;
    (*path_6).direction_0 = next_direction_0;
    return true;
}

fn set_word_0( path_7 : u32,  which_6 : u32,  value_4 : u32)
{
    paths_0[which_6 * launch_0.room_0 + path_7] = value_4;
    return;
}

fn set_vector_0( path_8 : u32,  which_7 : ptr<function, u32>,  value_5 : vec3<f32>)
{
    var axis_6 : u32 = u32(0);
    for(;;)
    {
        if(axis_6 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_8, (*which_7) + axis_6, (bitcast<u32>((value_5[axis_6]))));
        axis_6 = axis_6 + u32(1);
    }
    (*which_7) = (*which_7) + u32(3);
    return;
}

fn set_vector_1( path_9 : u32,  which_8 : ptr<function, u32>,  value_6 : vec3<f32>)
{
    var axis_7 : u32 = u32(0);
    for(;;)
    {
        if(axis_7 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_9, (*which_8) + axis_7, (bitcast<u32>((value_6[axis_7]))));
        axis_7 = axis_7 + u32(1);
    }
    (*which_8) = (*which_8) + u32(3);
    return;
}

fn set_colour_0( path_10 : u32,  which_9 : ptr<function, u32>,  colour_4 : Colour_0)
{
    set_vector_1(path_10, &((*which_9)), colour_4.value_0);
    var k_11 : u32 = u32(0);
    for(;;)
    {
        if(k_11 < u32(1))
        {
        }
        else
        {
            break;
        }
        set_vector_1(path_10, &((*which_9)), colour_4.changes_0[k_11]);
        k_11 = k_11 + u32(1);
    }
    return;
}

fn set_place_0( path_11 : u32,  which_10 : ptr<function, u32>,  place_14 : Place_0)
{
    set_word_0(path_11, (*which_10), place_14.triangle_0);
    set_word_0(path_11, (*which_10) + u32(1), (bitcast<u32>((place_14.v_0))));
    set_word_0(path_11, (*which_10) + u32(2), (bitcast<u32>((place_14.w_0))));
    (*which_10) = (*which_10) + u32(3);
    return;
}

fn store_0( number_of_path_1 : u32,  path_12 : Path_0)
{
    var at_17 : u32 = u32(1);
    set_colour_0(number_of_path_1, &(at_17), path_12.light_0);
    set_colour_0(number_of_path_1, &(at_17), path_12.throughput_0);
    set_vector_0(number_of_path_1, &(at_17), path_12.direction_0);
    set_place_0(number_of_path_1, &(at_17), path_12.place_1);
    set_word_0(number_of_path_1, at_17, path_12.key_0.x);
    set_word_0(number_of_path_1, at_17 + u32(1), path_12.key_0.y);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn go_on_forward(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var at_18 : u32 = launch_0.first_0 + thread_0.x;
    if(at_18 >= (launch_0.end_0))
    {
        return;
    }
    var number_of_path_2 : u32 = input_0[at_18];
    var path_13 : Path_0 = load_0(number_of_path_2);
    var vertex_2 : Vertex_0 = dark_vertex_0();
    var goes_on_2 : bool = take_further_0(&(path_13), &(vertex_2), vec3<f32>(0.0f));
    path_13.light_0 = x2B_0(path_13.light_0, x2A_1(path_13.throughput_0, vertex_2.direct_0));
    path_13.throughput_0 = x2A_1(path_13.throughput_0, vertex_2.onward_0);
    store_0(number_of_path_2, path_13);
    var _S160 : u32;
    if(goes_on_2)
    {
        _S160 = number_of_path_2;
    }
    else
    {
        _S160 = u32(4294967295);
    }
    set_word_0(at_18, u32(0), _S160);
    return;
}
