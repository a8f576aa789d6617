// Compiled from hits.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: fe920d1328062107
// result: bd1a154ce4078a53

struct Launch_std140_0
{
    @align(16) first_0 : u32,
    @align(4) end_0 : u32,
    @align(8) room_0 : u32,
    @align(4) depth_0 : u32,
};

@binding(8) @group(0) var<uniform> launch_0 : Launch_std140_0;
@binding(5) @group(0) var<storage, read> input_0 : array<u32>;

@binding(4) @group(0) var<storage, read> scene_0 : array<u32>;

@binding(2) @group(0) var<storage, read> primitives_0 : array<f32>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

fn word_0( at_0 : u32) -> u32
{
    return scene_0[at_0];
}

struct Place_0
{
     triangle_0 : u32,
     v_0 : f32,
     w_0 : f32,
};

struct Found_0
{
     face_0 : u32,
     triangle_1 : u32,
     v_1 : f32,
     w_1 : f32,
};

fn place_of_0( found_0 : Found_0) -> Place_0
{
    var place_0 : Place_0;
    place_0.triangle_0 = found_0.triangle_1;
    place_0.v_0 = found_0.v_1;
    place_0.w_0 = found_0.w_1;
    return place_0;
}

fn constant_0( value_0 : vec3<f32>) -> vec3<f32>
{
    return value_0;
}

fn triangle_record_0( triangle_2 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_2;
}

fn shape_of_0( triangle_3 : u32) -> u32
{
    return word_0(u32(10)) + u32(6) * word_0(triangle_record_0(triangle_3));
}

fn primitive_vector_0( at_1 : u32) -> vec3<f32>
{
    return vec3<f32>(primitives_0[at_1], primitives_0[at_1 + u32(1)], primitives_0[at_1 + u32(2)]);
}

fn cross_of_0( triangle_4 : u32) -> vec3<f32>
{
    var at_2 : u32 = u32(9) * triangle_4;
    var a_0 : vec3<f32> = primitive_vector_0(at_2);
    return cross(primitive_vector_0(at_2 + u32(3)) - a_0, primitive_vector_0(at_2 + u32(6)) - a_0);
}

fn emitter_seen_0( found_1 : Found_0,  direction_0 : vec3<f32>) -> u32
{
    if((found_1.face_0) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_0 : u32 = word_0(shape_of_0(found_1.triangle_1) + u32(4));
    var _S1 : bool;
    if(emitter_0 != u32(4294967295))
    {
        _S1 = (dot(cross_of_0(found_1.triangle_1), direction_0)) < 0.0f;
    }
    else
    {
        _S1 = false;
    }
    var _S2 : u32;
    if(_S1)
    {
        _S2 = emitter_0;
    }
    else
    {
        _S2 = u32(4294967295);
    }
    return _S2;
}

fn emitter_record_0( emitter_1 : u32) -> u32
{
    return word_0(u32(11)) + u32(12) * emitter_1;
}

fn is_map_0( record_0 : u32) -> bool
{
    return (word_0(record_0)) == u32(2);
}

fn number_0( at_3 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_3])));
}

fn vector_at_0( at_4 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_4), number_0(at_4 + u32(1)), number_0(at_4 + u32(2)));
}

fn angle_of_0( x_0 : f32,  y_0 : f32) -> f32
{
    var _S3 : f32 = abs(x_0);
    var _S4 : f32 = abs(y_0);
    var _S5 : f32 = min(_S3, _S4);
    var _S6 : f32 = max(_S3, _S4);
    var is_steep_0 : bool = _S5 > (0.41421356797218323f * _S6);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S5 - _S6;
    }
    else
    {
        above_0 = _S5;
    }
    var below_0 : f32;
    if(is_steep_0)
    {
        below_0 = _S5 + _S6;
    }
    else
    {
        below_0 = _S6;
    }
    if(below_0 > 0.0f)
    {
    }
    else
    {
        below_0 = 1.0f;
    }
    var t_0 : f32 = above_0 / below_0;
    var z_0 : f32 = t_0 * t_0;
    var angle_0 : f32 = (((0.08053744584321976f * z_0 - 0.13877685368061066f) * z_0 + 0.19977711141109467f) * z_0 - 0.33332949876785278f) * z_0 * t_0 + t_0;
    var angle_1 : f32;
    if(is_steep_0)
    {
        angle_1 = angle_0 + 0.78539818525314331f;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(_S4 > _S3)
    {
        angle_1 = 1.57079637050628662f - angle_1;
    }
    else
    {
    }
    if(x_0 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    else
    {
    }
    if(y_0 < 0.0f)
    {
        above_0 = - angle_1;
    }
    else
    {
        above_0 = angle_1;
    }
    return above_0;
}

fn map_place_0( map_0 : u32,  direction_1 : vec3<f32>) -> vec2<f32>
{
    var _S7 : u32 = map_0 + u32(2);
    var d_0 : vec3<f32> = vector_at_0(_S7) * vec3<f32>(direction_1.x) + vector_at_0(_S7 + u32(3)) * vec3<f32>(direction_1.y) + vector_at_0(_S7 + u32(6)) * vec3<f32>(direction_1.z);
    return vec2<f32>(angle_of_0(- d_0.z, d_0.x) * 0.15915493667125702f * f32(word_0(map_0)) - 0.5f, angle_of_0(d_0.y, length(d_0.xz)) * 0.31830987334251404f * (f32(word_0(map_0 + u32(1))) - 1.0f));
}

fn floor_of_0( x_1 : f32) -> i32
{
    return i32(floor(clamp(x_1, -1.0e+09f, 1.0e+09f)));
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

struct Lookup_0
{
     count_0 : u32,
     texels_0 : vec4<u32>,
     weights_0 : vec4<f32>,
};

fn between_0( texels_1 : vec4<u32>,  way_0 : vec2<f32>) -> Lookup_0
{
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - way_0;
    var lookup_0 : Lookup_0;
    lookup_0.count_0 = u32(4);
    lookup_0.texels_0 = texels_1;
    var _S8 : f32 = back_0.x;
    var _S9 : f32 = back_0.y;
    var _S10 : f32 = way_0.x;
    var _S11 : f32 = way_0.y;
    lookup_0.weights_0 = vec4<f32>(_S8 * _S9, _S10 * _S9, _S8 * _S11, _S10 * _S11);
    return lookup_0;
}

fn in_map_0( map_1 : u32,  direction_2 : vec3<f32>) -> Lookup_0
{
    var place_1 : vec2<f32> = map_place_0(map_1, direction_2);
    var x_2 : i32 = floor_of_0(place_1.x);
    var y_1 : i32 = floor_of_0(place_1.y);
    var width_0 : i32 = i32(word_0(map_1));
    var height_0 : i32 = i32(word_0(map_1 + u32(1)));
    var left_0 : u32 = wrapped_0(x_2, width_0, u32(0));
    var right_0 : u32 = wrapped_0(x_2 + i32(1), width_0, u32(0));
    var _S12 : u32 = wrapped_0(y_1, height_0, u32(2));
    var _S13 : u32 = u32(width_0);
    var first_1 : u32 = _S12 * _S13;
    var _S14 : u32 = wrapped_0(y_1 + i32(1), height_0, u32(2));
    var second_0 : u32 = _S14 * _S13;
    return between_0(vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0), place_1 - floor(place_1));
}

fn one_texel_0( texel_0 : u32) -> Lookup_0
{
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(1);
    lookup_1.texels_0 = vec4<u32>(texel_0, u32(0), u32(0), u32(0));
    lookup_1.weights_0 = vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f);
    return lookup_1;
}

fn uv_of_0( place_2 : Place_0) -> vec2<f32>
{
    var uvs_0 : u32 = word_0(shape_of_0(place_2.triangle_0) + u32(1));
    if(uvs_0 == u32(4294967295))
    {
        return vec2<f32>(place_2.v_0, place_2.w_0);
    }
    var at_5 : u32 = uvs_0 + u32(6) * word_0(triangle_record_0(place_2.triangle_0) + u32(1));
    return vec2<f32>(number_0(at_5), number_0(at_5 + u32(1))) * vec2<f32>((1.0f - place_2.v_0 - place_2.w_0)) + vec2<f32>(number_0(at_5 + u32(2)), number_0(at_5 + u32(3))) * vec2<f32>(place_2.v_0) + vec2<f32>(number_0(at_5 + u32(4)), number_0(at_5 + u32(5))) * vec2<f32>(place_2.w_0);
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : vec2<f32>) -> Lookup_0
{
    var width_1 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_1 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var place_3 : vec2<f32> = uv_0 * vec2<f32>(f32(width_1), f32(height_1));
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_3.y), height_1, wrap_1);
        var _S15 : u32 = row_0 * u32(width_1);
        var _S16 : u32 = wrapped_0(floor_of_0(place_3.x), width_1, wrap_1);
        return one_texel_0(_S15 + _S16);
    }
    var place_4 : vec2<f32> = place_3 - vec2<f32>(0.5f);
    var x_3 : i32 = floor_of_0(place_4.x);
    var y_2 : i32 = floor_of_0(place_4.y);
    var _S17 : u32 = wrapped_0(y_2, height_1, wrap_1);
    var _S18 : u32 = u32(width_1);
    var first_2 : u32 = _S17 * _S18;
    var _S19 : u32 = wrapped_0(y_2 + i32(1), height_1, wrap_1);
    var second_1 : u32 = _S19 * _S18;
    var left_1 : u32 = wrapped_0(x_3, width_1, wrap_1);
    var right_1 : u32 = wrapped_0(x_3 + i32(1), width_1, wrap_1);
    return between_0(vec4<u32>(first_2 + left_1, first_2 + right_1, second_1 + left_1, second_1 + right_1), place_4 - floor(place_4));
}

fn lookup_at_0( texture_1 : u32,  place_5 : Place_0) -> Lookup_0
{
    var kind_0 : u32 = word_0(texture_1);
    if(kind_0 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_1 : u32 = triangle_record_0(place_5.triangle_0) + u32(1);
    if(kind_0 == u32(4))
    {
        return one_texel_0(word_0(record_1));
    }
    if(kind_0 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_1 + u32(1)), word_0(record_1 + u32(2)), word_0(record_1 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_5.v_0 - place_5.w_0, place_5.v_0, place_5.w_0, 0.0f);
        return lookup_2;
    }
    var rows_0 : u32 = texture_1 + u32(6);
    var _S20 : vec3<f32> = vec3<f32>(uv_of_0(place_5), 1.0f);
    var uv_1 : vec2<f32> = vec2<f32>(dot(_S20, vector_at_0(rows_0)), dot(_S20, vector_at_0(rows_0 + u32(3))));
    if(kind_0 == u32(1))
    {
        var _S21 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S21;
    }
    var half_of_period_0 : vec2<f32> = uv_1 - floor(uv_1);
    var _S22 : i32;
    if(((half_of_period_0.x) > 0.5f) != ((half_of_period_0.y) > 0.5f))
    {
        _S22 = i32(1);
    }
    else
    {
        _S22 = i32(0);
    }
    return one_texel_0(u32(_S22));
}

fn texture_value_0( texture_2 : u32,  lookup_3 : Lookup_0) -> vec3<f32>
{
    var _S23 : u32 = word_0(texture_2 + u32(1));
    var _S24 : u32 = texture_2 + u32(13);
    var _S25 : vec3<f32> = vec3<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var value_1 : vec3<f32> = _S25;
    for(;;)
    {
        if(k_0 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_6 : u32 = _S24 + _S23 * lookup_3.texels_0[k_0];
        var _S26 : vec3<f32>;
        if(_S23 == u32(1))
        {
            _S26 = vec3<f32>(number_0(at_6));
        }
        else
        {
            _S26 = vector_at_0(at_6);
        }
        var value_2 : vec3<f32> = value_1 + _S26 * vec3<f32>(lookup_3.weights_0[k_0]);
        k_0 = k_0 + u32(1);
        value_1 = value_2;
    }
    return value_1;
}

fn looked_up_0( texture_3 : u32,  lookup_4 : Lookup_0) -> vec3<f32>
{
    return constant_0(texture_value_0(texture_3, lookup_4));
}

fn arriving_0( emitter_2 : u32,  place_6 : Place_0,  direction_3 : vec3<f32>,  factor_0 : vec3<f32>,  importance_0 : vec3<f32>) -> vec3<f32>
{
    var record_2 : u32 = emitter_record_0(emitter_2);
    var texture_4 : u32 = word_0(record_2 + u32(1));
    var _S27 : vec3<f32>;
    var texture_5 : u32;
    var lookup_5 : Lookup_0;
    if(is_map_0(record_2))
    {
        var _S28 : vec3<f32> = factor_0 * vector_at_0(texture_4 + u32(11));
        var _S29 : Lookup_0 = in_map_0(texture_4, direction_3);
        var _S30 : u32 = word_0(texture_4 + u32(14));
        _S27 = _S28;
        texture_5 = _S30;
        lookup_5 = _S29;
    }
    else
    {
        var _S31 : Lookup_0 = lookup_at_0(texture_4, place_6);
        _S27 = factor_0;
        texture_5 = texture_4;
        lookup_5 = _S31;
    }
    return _S27 * looked_up_0(texture_5, lookup_5);
}

fn set_word_0( path_0 : u32,  which_0 : u32,  value_3 : u32)
{
    paths_0[which_0 * launch_0.room_0 + path_0] = value_3;
    return;
}

fn set_vector_0( path_1 : u32,  which_1 : ptr<function, u32>,  value_4 : vec3<f32>)
{
    var axis_0 : u32 = u32(0);
    for(;;)
    {
        if(axis_0 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_1, (*which_1) + axis_0, (bitcast<u32>((value_4[axis_0]))));
        axis_0 = axis_0 + u32(1);
    }
    (*which_1) = (*which_1) + u32(3);
    return;
}

fn set_vector_1( path_2 : u32,  which_2 : ptr<function, u32>,  value_5 : vec3<f32>)
{
    var axis_1 : u32 = u32(0);
    for(;;)
    {
        if(axis_1 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_2, (*which_2) + axis_1, (bitcast<u32>((value_5[axis_1]))));
        axis_1 = axis_1 + u32(1);
    }
    (*which_2) = (*which_2) + u32(3);
    return;
}

fn set_colour_0( path_3 : u32,  which_3 : ptr<function, u32>,  colour_0 : vec3<f32>)
{
    set_vector_1(path_3, &((*which_3)), colour_0);
    return;
}

fn set_place_0( path_4 : u32,  which_4 : ptr<function, u32>,  place_7 : Place_0)
{
    set_word_0(path_4, (*which_4), place_7.triangle_0);
    set_word_0(path_4, (*which_4) + u32(1), (bitcast<u32>((place_7.v_0))));
    set_word_0(path_4, (*which_4) + u32(2), (bitcast<u32>((place_7.w_0))));
    (*which_4) = (*which_4) + u32(3);
    return;
}

struct Path_0
{
     throughput_0 : vec3<f32>,
     direction_4 : vec3<f32>,
     place_8 : Place_0,
     key_0 : vec2<u32>,
     light_0 : vec3<f32>,
};

fn store_0( number_of_path_0 : u32,  path_5 : Path_0)
{
    var at_7 : u32 = u32(1);
    set_colour_0(number_of_path_0, &(at_7), path_5.light_0);
    set_colour_0(number_of_path_0, &(at_7), path_5.throughput_0);
    set_vector_0(number_of_path_0, &(at_7), path_5.direction_4);
    set_place_0(number_of_path_0, &(at_7), path_5.place_8);
    set_word_0(number_of_path_0, at_7, path_5.key_0.x);
    set_word_0(number_of_path_0, at_7 + u32(1), path_5.key_0.y);
    return;
}

fn reaches_0( segments_0 : u32) -> bool
{
    return segments_0 <= (word_0(u32(0)));
}

@compute
@workgroup_size(64, 1, 1)
fn begin_at_hits(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var number_of_path_1 : u32 = launch_0.first_0 + thread_0.x;
    if(number_of_path_1 >= (launch_0.end_0))
    {
        return;
    }
    var at_8 : u32 = u32(8) * number_of_path_1;
    var found_2 : Found_0;
    var _S32 : u32 = input_0[at_8];
    found_2.face_0 = _S32;
    var _S33 : u32;
    if(_S32 == u32(4294967295))
    {
        _S33 = u32(0);
    }
    else
    {
        _S33 = word_0(word_0(u32(12)) + found_2.face_0);
    }
    found_2.triangle_1 = _S33;
    found_2.v_1 = (bitcast<f32>((input_0[at_8 + u32(1)])));
    found_2.w_1 = (bitcast<f32>((input_0[at_8 + u32(2)])));
    var path_6 : Path_0;
    path_6.place_8 = place_of_0(found_2);
    var _S34 : vec3<f32> = (bitcast<vec3<f32>>((vec3<u32>(input_0[at_8 + u32(3)], input_0[at_8 + u32(4)], input_0[at_8 + u32(5)]))));
    path_6.direction_4 = _S34;
    path_6.key_0 = vec2<u32>(input_0[at_8 + u32(6)], input_0[at_8 + u32(7)]);
    path_6.throughput_0 = constant_0(vec3<f32>(1.0f));
    var _S35 : vec3<f32> = vec3<f32>(0.0f);
    path_6.light_0 = constant_0(_S35);
    var emitter_3 : u32 = emitter_seen_0(found_2, _S34);
    var _S36 : bool;
    if(emitter_3 != u32(4294967295))
    {
        _S36 = (word_0(u32(4))) != u32(0);
    }
    else
    {
        _S36 = false;
    }
    if(_S36)
    {
        var _S37 : vec3<f32> = arriving_0(emitter_3, path_6.place_8, path_6.direction_4, path_6.throughput_0, _S35);
        path_6.light_0 = _S37;
    }
    store_0(number_of_path_1, path_6);
    if((found_2.face_0) != u32(4294967295))
    {
        _S36 = reaches_0(u32(2));
    }
    else
    {
        _S36 = false;
    }
    if(_S36)
    {
        _S33 = number_of_path_1;
    }
    else
    {
        _S33 = u32(4294967295);
    }
    set_word_0(number_of_path_1, u32(0), _S33);
    return;
}
