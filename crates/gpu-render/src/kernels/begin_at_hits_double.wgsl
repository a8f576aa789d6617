// Compiled from hits.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: 6d203acca3fb11be
// result: d994fa4161e21621

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

@binding(2) @group(0) var<storage, read> primitives_0 : array<f64>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

fn word_0( at_0 : u32) -> u32
{
    return scene_0[at_0];
}

struct Place_0
{
     triangle_0 : u32,
     v_0 : f32,
     w_0 : f32,
     v_rest_0 : f32,
     w_rest_0 : f32,
};

fn exact_place_0( triangle_1 : u32,  v_1 : f64,  w_1 : f64) -> Place_0
{
    var place_0 : Place_0;
    place_0.triangle_0 = triangle_1;
    var _S1 : f32 = f32(v_1);
    place_0.v_0 = _S1;
    var _S2 : f32 = f32(w_1);
    place_0.w_0 = _S2;
    place_0.v_rest_0 = f32(v_1 - f64(_S1));
    place_0.w_rest_0 = f32(w_1 - f64(_S2));
    return place_0;
}

struct Found_0
{
     face_0 : u32,
     triangle_2 : u32,
     v_2 : f64,
     w_2 : f64,
};

fn place_of_0( found_0 : Found_0) -> Place_0
{
    return exact_place_0(found_0.triangle_2, found_0.v_2, found_0.w_2);
}

fn changing_0( value_0 : vec3<f32>,  change_0 : vec3<f32>) -> vec3<f32>
{
    return value_0;
}

fn still_0( value_1 : vec3<f32>) -> vec3<f32>
{
    return changing_0(value_1, vec3<f32>(0.0f));
}

fn triangle_record_0( triangle_3 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_3;
}

fn shape_of_0( triangle_4 : u32) -> u32
{
    return word_0(u32(10)) + u32(7) * word_0(triangle_record_0(triangle_4));
}

fn primitive_vector_0( at_1 : u32) -> vec3<f64>
{
    return vec3<f64>(primitives_0[at_1], primitives_0[at_1 + u32(1)], primitives_0[at_1 + u32(2)]);
}

fn cross_of_0( triangle_5 : u32) -> vec3<f32>
{
    var at_2 : u32 = u32(9) * triangle_5;
    var a_0 : vec3<f64> = primitive_vector_0(at_2);
    return cross(vec3<f32>(primitive_vector_0(at_2 + u32(3)) - a_0), vec3<f32>(primitive_vector_0(at_2 + u32(6)) - a_0));
}

fn emitter_seen_0( found_1 : Found_0,  direction_0 : vec3<f32>) -> u32
{
    if((found_1.face_0) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_0 : u32 = word_0(shape_of_0(found_1.triangle_2) + u32(4));
    var _S3 : bool;
    if(emitter_0 != u32(4294967295))
    {
        _S3 = (dot(cross_of_0(found_1.triangle_2), direction_0)) < 0.0f;
    }
    else
    {
        _S3 = false;
    }
    var _S4 : u32;
    if(_S3)
    {
        _S4 = emitter_0;
    }
    else
    {
        _S4 = u32(4294967295);
    }
    return _S4;
}

fn emitter_record_0( emitter_1 : u32) -> u32
{
    return word_0(u32(11)) + u32(12) * emitter_1;
}

fn is_map_0( record_0 : u32) -> bool
{
    return (word_0(record_0)) == u32(2);
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

struct Corners2_0
{
     a_1 : vec2<f64>,
     b_0 : vec2<f64>,
     c_0 : vec2<f64>,
};

fn Corners2_x24init_0( a_2 : vec2<f64>,  b_1 : vec2<f64>,  c_1 : vec2<f64>) -> Corners2_0
{
    var _S5 : Corners2_0;
    _S5.a_1 = a_2;
    _S5.b_0 = b_1;
    _S5.c_0 = c_1;
    return _S5;
}

fn number_0( at_3 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_3])));
}

fn precise_0( at_4 : u32) -> f64
{
    return f64(number_0(at_4)) + f64(number_0(at_4 + u32(1)));
}

fn uvs_of_0( triangle_6 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f64>(0.0lf, 0.0lf), vec2<f64>(1.0lf, 0.0lf), vec2<f64>(0.0lf, 1.0lf));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_6) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_5 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_6) + u32(1));
    uvs_0.a_1 = vec2<f64>(precise_0(at_5), precise_0(at_5 + u32(2)));
    uvs_0.b_0 = vec2<f64>(precise_0(at_5 + u32(4)), precise_0(at_5 + u32(6)));
    uvs_0.c_0 = vec2<f64>(precise_0(at_5 + u32(8)), precise_0(at_5 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_6 : u32) -> vec3<f64>
{
    return vec3<f64>(precise_0(at_6), precise_0(at_6 + u32(2)), precise_0(at_6 + u32(4)));
}

fn floor_of_0( x_0 : f64) -> i32
{
    return i32(clamp(f32(floor(x_0)), -1.0e+09f, 1.0e+09f));
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

struct Point_0
{
     value_2 : vec2<f64>,
};

fn between_0( texels_1 : vec4<u32>,  place_1 : Point_0) -> Lookup_0
{
    var _S6 : vec2<f32> = vec2<f32>(place_1.value_2 - floor(place_1.value_2));
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - _S6;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S7 : f32 = back_0.x;
    var _S8 : f32 = back_0.y;
    var _S9 : f32 = _S6.x;
    var _S10 : f32 = _S6.y;
    lookup_1.weights_0 = vec4<f32>(_S7 * _S8, _S9 * _S8, _S7 * _S10, _S9 * _S10);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var place_2 : vec2<f64> = uv_0.value_2 * vec2<f64>(vec2<f32>(f32(width_0), f32(height_0)));
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_2.y), height_0, wrap_1);
        var _S11 : u32 = row_0 * u32(width_0);
        var _S12 : u32 = wrapped_0(floor_of_0(place_2.x), width_0, wrap_1);
        return one_texel_0(_S11 + _S12);
    }
    var centred_0 : Point_0;
    var _S13 : vec2<f64> = place_2 - vec2<f64>(0.5lf);
    centred_0.value_2 = _S13;
    var x_1 : i32 = floor_of_0(_S13.x);
    var y_0 : i32 = floor_of_0(_S13.y);
    var _S14 : u32 = wrapped_0(y_0, height_0, wrap_1);
    var _S15 : u32 = u32(width_0);
    var first_1 : u32 = _S14 * _S15;
    var _S16 : u32 = wrapped_0(y_0 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S16 * _S15;
    var left_0 : u32 = wrapped_0(x_1, width_0, wrap_1);
    var right_0 : u32 = wrapped_0(x_1 + i32(1), width_0, wrap_1);
    return between_0(vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_3 : Place_0) -> Lookup_0
{
    var kind_0 : u32 = word_0(texture_1);
    if(kind_0 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_1 : u32 = triangle_record_0(place_3.triangle_0) + u32(1);
    if(kind_0 == u32(4))
    {
        return one_texel_0(word_0(record_1));
    }
    if(kind_0 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_1 + u32(1)), word_0(record_1 + u32(2)), word_0(record_1 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_3.v_0 - place_3.w_0, place_3.v_0, place_3.w_0, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_3.triangle_0);
    var _S17 : u32 = texture_1 + u32(6);
    var uv_1 : Point_0;
    var _S18 : vec3<f64> = vec3<f64>(uvs_1.a_1 + (uvs_1.b_0 - uvs_1.a_1) * vec2<f64>((f64(place_3.v_0) + f64(place_3.v_rest_0))) + (uvs_1.c_0 - uvs_1.a_1) * vec2<f64>((f64(place_3.w_0) + f64(place_3.w_rest_0))), 1.0lf);
    uv_1.value_2 = vec2<f64>(dot(_S18, row_at_0(_S17)), dot(_S18, row_at_0(_S17 + u32(6))));
    if(kind_0 == u32(1))
    {
        var _S19 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S19;
    }
    var half_of_period_0 : vec2<f64> = uv_1.value_2 - floor(uv_1.value_2);
    var _S20 : i32;
    if(((half_of_period_0.x) > 0.5lf) != ((half_of_period_0.y) > 0.5lf))
    {
        _S20 = i32(1);
    }
    else
    {
        _S20 = i32(0);
    }
    return one_texel_0(u32(_S20));
}

fn vector_at_0( at_7 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_7), number_0(at_7 + u32(1)), number_0(at_7 + u32(2)));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_1 : vec4<f32>) -> vec3<f32>
{
    var _S21 : u32 = word_0(texture_2 + u32(1));
    var _S22 : u32 = texture_2 + u32(19);
    var _S23 : vec3<f32> = vec3<f32>(0.0f);
    var k_0 : u32 = u32(0);
    var value_3 : vec3<f32> = _S23;
    for(;;)
    {
        if(k_0 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_8 : u32 = _S22 + _S21 * lookup_3.texels_0[k_0];
        var _S24 : vec3<f32>;
        if(_S21 == u32(1))
        {
            _S24 = vec3<f32>(number_0(at_8));
        }
        else
        {
            _S24 = vector_at_0(at_8);
        }
        var value_4 : vec3<f32> = value_3 + _S24 * vec3<f32>(weights_1[k_0]);
        k_0 = k_0 + u32(1);
        value_3 = value_4;
    }
    return value_3;
}

fn looked_up_0( texture_3 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> vec3<f32>
{
    return weighted_texels_0(texture_3, lookup_4, lookup_4.weights_0);
}

fn shown_0( texture_4 : u32,  place_4 : Place_0) -> vec3<f32>
{
    var _S25 : Lookup_0 = lookup_at_0(texture_4, place_4);
    return looked_up_0(texture_4, _S25, vec2<f32>(0.0f));
}

fn value_of_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vector_0;
}

fn angle_of_0( x_2 : f32,  y_1 : f32) -> f32
{
    var _S26 : f32 = abs(x_2);
    var _S27 : f32 = abs(y_1);
    var _S28 : f32 = min(_S26, _S27);
    var _S29 : f32 = max(_S26, _S27);
    var is_steep_0 : bool = _S28 > (0.41421356797218323f * _S29);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S28 - _S29;
    }
    else
    {
        above_0 = _S28;
    }
    var below_0 : f32;
    if(is_steep_0)
    {
        below_0 = _S28 + _S29;
    }
    else
    {
        below_0 = _S29;
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
    if(_S27 > _S26)
    {
        angle_1 = 1.57079637050628662f - angle_1;
    }
    if(x_2 < 0.0f)
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

fn map_place_0( map_0 : u32,  direction_1 : vec3<f32>) -> vec2<f32>
{
    var _S30 : u32 = map_0 + u32(2);
    var d_0 : vec3<f32> = vector_at_0(_S30) * vec3<f32>(direction_1.x) + vector_at_0(_S30 + u32(3)) * vec3<f32>(direction_1.y) + vector_at_0(_S30 + u32(6)) * vec3<f32>(direction_1.z);
    return vec2<f32>(angle_of_0(- d_0.z, d_0.x) * 0.15915493667125702f * f32(word_0(map_0)) - 0.5f, angle_of_0(d_0.y, length(d_0.xz)) * 0.31830987334251404f * (f32(word_0(map_0 + u32(1))) - 1.0f));
}

fn in_map_0( map_1 : u32,  direction_2 : vec3<f32>) -> Lookup_0
{
    var _S31 : vec2<f64> = vec2<f64>(map_place_0(map_1, direction_2));
    var point_0 : Point_0;
    point_0.value_2 = _S31;
    var x_3 : i32 = floor_of_0(_S31.x);
    var y_2 : i32 = floor_of_0(_S31.y);
    var width_1 : i32 = i32(word_0(map_1));
    var height_1 : i32 = i32(word_0(map_1 + u32(1)));
    var left_1 : u32 = wrapped_0(x_3, width_1, u32(0));
    var right_1 : u32 = wrapped_0(x_3 + i32(1), width_1, u32(0));
    var _S32 : u32 = wrapped_0(y_2, height_1, u32(2));
    var _S33 : u32 = u32(width_1);
    var first_2 : u32 = _S32 * _S33;
    var _S34 : u32 = wrapped_0(y_2 + i32(1), height_1, u32(2));
    var second_1 : u32 = _S34 * _S33;
    return between_0(vec4<u32>(first_2 + left_1, first_2 + right_1, second_1 + left_1, second_1 + right_1), point_0);
}

fn emitted_0( emitter_2 : u32,  place_5 : Place_0,  direction_3 : vec3<f32>) -> vec3<f32>
{
    var record_2 : u32 = emitter_record_0(emitter_2);
    var texture_5 : u32 = word_0(record_2 + u32(1));
    if(!is_map_0(record_2))
    {
        var _S35 : vec3<f32> = shown_0(texture_5, place_5);
        return _S35;
    }
    var change_1 : vec2<f32> = vec2<f32>(0.0f);
    var factor_0 : vec3<f32> = looked_up_0(word_0(texture_5 + u32(12)), one_texel_0(u32(0)), change_1);
    var _S36 : u32 = word_0(texture_5 + u32(11));
    var _S37 : Lookup_0 = in_map_0(texture_5, value_of_0(direction_3));
    return looked_up_0(_S36, _S37, change_1) * factor_0;
}

fn set_word_0( path_0 : u32,  which_0 : u32,  value_5 : u32)
{
    paths_0[which_0 * launch_0.room_0 + path_0] = value_5;
    return;
}

fn set_vector_0( path_1 : u32,  which_1 : ptr<function, u32>,  value_6 : vec3<f32>)
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
        set_word_0(path_1, (*which_1) + axis_0, (bitcast<u32>((value_6[axis_0]))));
        axis_0 = axis_0 + u32(1);
    }
    (*which_1) = (*which_1) + u32(3);
    return;
}

fn set_vector_1( path_2 : u32,  which_2 : ptr<function, u32>,  value_7 : vec3<f32>)
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
        set_word_0(path_2, (*which_2) + axis_1, (bitcast<u32>((value_7[axis_1]))));
        axis_1 = axis_1 + u32(1);
    }
    (*which_2) = (*which_2) + u32(3);
    return;
}

fn set_changing_0( path_3 : u32,  which_3 : ptr<function, u32>,  vector_1 : vec3<f32>)
{
    set_vector_1(path_3, &((*which_3)), value_of_0(vector_1));
    return;
}

fn set_place_0( path_4 : u32,  which_4 : ptr<function, u32>,  place_6 : Place_0)
{
    set_word_0(path_4, (*which_4), place_6.triangle_0);
    set_word_0(path_4, (*which_4) + u32(1), (bitcast<u32>((place_6.v_0))));
    set_word_0(path_4, (*which_4) + u32(2), (bitcast<u32>((place_6.w_0))));
    set_word_0(path_4, (*which_4) + u32(3), (bitcast<u32>((place_6.v_rest_0))));
    set_word_0(path_4, (*which_4) + u32(4), (bitcast<u32>((place_6.w_rest_0))));
    (*which_4) = (*which_4) + u32(5);
    return;
}

struct Path_0
{
     throughput_0 : vec3<f32>,
     direction_4 : vec3<f32>,
     place_7 : Place_0,
     key_0 : vec2<u32>,
     direction_rest_0 : vec3<f32>,
     light_0 : vec3<f32>,
};

fn store_0( number_of_path_0 : u32,  path_5 : Path_0)
{
    var at_9 : u32 = u32(1);
    set_changing_0(number_of_path_0, &(at_9), path_5.light_0);
    set_changing_0(number_of_path_0, &(at_9), path_5.throughput_0);
    set_changing_0(number_of_path_0, &(at_9), path_5.direction_4);
    set_place_0(number_of_path_0, &(at_9), path_5.place_7);
    var _S38 : u32 = at_9 + u32(1);
    set_word_0(number_of_path_0, at_9, path_5.key_0.x);
    at_9 = _S38 + u32(1);
    set_word_0(number_of_path_0, _S38, path_5.key_0.y);
    set_vector_0(number_of_path_0, &(at_9), path_5.direction_rest_0);
    return;
}

fn reaches_0( segments_0 : u32) -> bool
{
    return segments_0 <= (word_0(u32(0)));
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S39 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S40 : u32 = u32(2) + zero_0;
        _S39 = _S40;
        if(rounds_0 < _S40)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S39;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S41 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
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
    var at_10 : u32 = u32(13) * number_of_path_1;
    var found_2 : Found_0;
    var _S42 : u32 = input_0[at_10];
    found_2.face_0 = _S42;
    var _S43 : u32;
    if(_S42 == u32(4294967295))
    {
        _S43 = u32(0);
    }
    else
    {
        _S43 = word_0(word_0(u32(12)) + found_2.face_0);
    }
    found_2.triangle_2 = _S43;
    found_2.v_2 = f64((bitcast<f32>((input_0[at_10 + u32(1)])))) + f64((bitcast<f32>((input_0[at_10 + u32(2)]))));
    found_2.w_2 = f64((bitcast<f32>((input_0[at_10 + u32(3)])))) + f64((bitcast<f32>((input_0[at_10 + u32(4)]))));
    var path_6 : Path_0;
    path_6.place_7 = place_of_0(found_2);
    var _S44 : vec3<f32> = (bitcast<vec3<f32>>((vec3<u32>(input_0[at_10 + u32(5)], input_0[at_10 + u32(6)], input_0[at_10 + u32(7)]))));
    path_6.direction_4 = _S44;
    path_6.direction_rest_0 = (bitcast<vec3<f32>>((vec3<u32>(input_0[at_10 + u32(8)], input_0[at_10 + u32(9)], input_0[at_10 + u32(10)]))));
    path_6.key_0 = vec2<u32>(input_0[at_10 + u32(11)], input_0[at_10 + u32(12)]);
    path_6.throughput_0 = still_0(vec3<f32>(1.0f));
    path_6.light_0 = still_0(vec3<f32>(0.0f));
    var emitter_3 : u32 = emitter_seen_0(found_2, _S44);
    var _S45 : bool;
    if(emitter_3 != u32(4294967295))
    {
        _S45 = (word_0(u32(4))) != u32(0);
    }
    else
    {
        _S45 = false;
    }
    if(_S45)
    {
        var _S46 : vec3<f32> = emitted_0(emitter_3, path_6.place_7, path_6.direction_4);
        path_6.light_0 = _S46;
    }
    store_0(number_of_path_1, path_6);
    if((found_2.face_0) != u32(4294967295))
    {
        _S45 = reaches_0(u32(2));
    }
    else
    {
        _S45 = false;
    }
    if(_S45)
    {
        _S43 = number_of_path_1;
    }
    else
    {
        _S43 = u32(4294967295);
    }
    set_word_0(number_of_path_1, u32(0), _S43);
    check_loops_0();
    return;
}
