// Compiled from reverse.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: e9851084466382ed
// result: 603b725f67d86272

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

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

fn kept_at_0() -> u32
{
    return u32(18) + u32(25) * launch_0.depth_0;
}

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

struct Place_0
{
     triangle_0 : u32,
     v_0 : f32,
     w_0 : f32,
};

fn place_at_0( triangle_1 : u32,  v_1 : f32,  w_1 : f32) -> Place_0
{
    var place_0 : Place_0;
    place_0.triangle_0 = triangle_1;
    place_0.v_0 = v_1;
    place_0.w_0 = w_1;
    return place_0;
}

fn path_place_0( path_2 : u32,  which_2 : ptr<function, u32>) -> Place_0
{
    var _S2 : u32 = (*which_2) + u32(3);
    (*which_2) = _S2;
    return place_at_0(path_word_0(path_2, _S2 - u32(3)), (bitcast<f32>((path_word_0(path_2, _S2 - u32(2))))), (bitcast<f32>((path_word_0(path_2, _S2 - u32(1))))));
}

struct Colour_0
{
     value_0 : vec3<f32>,
     changes_0 : array<vec3<f32>, i32(2)>,
};

fn path_colour_0( path_3 : u32,  which_3 : ptr<function, u32>) -> Colour_0
{
    var colour_0 : Colour_0;
    var _S3 : vec3<f32> = path_vector_0(path_3, &((*which_3)));
    colour_0.value_0 = _S3;
    var k_0 : u32 = u32(0);
    for(;;)
    {
        if(k_0 < u32(2))
        {
        }
        else
        {
            break;
        }
        var _S4 : vec3<f32> = path_vector_0(path_3, &((*which_3)));
        colour_0.changes_0[k_0] = _S4;
        k_0 = k_0 + u32(1);
    }
    return colour_0;
}

fn word_0( at_0 : u32) -> u32
{
    return scene_0[at_0];
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

fn triangle_record_0( triangle_2 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_2;
}

struct Corners2_0
{
     a_0 : vec2<f32>,
     b_0 : vec2<f32>,
     c_0 : vec2<f32>,
};

fn Corners2_x24init_0( a_1 : vec2<f32>,  b_1 : vec2<f32>,  c_1 : vec2<f32>) -> Corners2_0
{
    var _S5 : Corners2_0;
    _S5.a_0 = a_1;
    _S5.b_0 = b_1;
    _S5.c_0 = c_1;
    return _S5;
}

fn shape_of_0( triangle_3 : u32) -> u32
{
    return word_0(u32(10)) + u32(6) * word_0(triangle_record_0(triangle_3));
}

fn number_0( at_1 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_1])));
}

fn uvs_of_0( triangle_4 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f32>(0.0f), vec2<f32>(1.0f, 0.0f), vec2<f32>(0.0f, 1.0f));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_4) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_2 : u32 = uvs_at_0 + u32(6) * word_0(triangle_record_0(triangle_4) + u32(1));
    uvs_0.a_0 = vec2<f32>(number_0(at_2), number_0(at_2 + u32(1)));
    uvs_0.b_0 = vec2<f32>(number_0(at_2 + u32(2)), number_0(at_2 + u32(3)));
    uvs_0.c_0 = vec2<f32>(number_0(at_2 + u32(4)), number_0(at_2 + u32(5)));
    return uvs_0;
}

fn vector_at_0( at_3 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_3), number_0(at_3 + u32(1)), number_0(at_3 + u32(2)));
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

struct Point_0
{
     value_1 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_1 : Point_0) -> Lookup_0
{
    var way_0 : vec2<f32> = place_1.value_1 - floor(place_1.value_1);
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - way_0;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S6 : f32 = back_0.x;
    var _S7 : f32 = back_0.y;
    var _S8 : f32 = way_0.x;
    var _S9 : f32 = way_0.y;
    lookup_1.weights_0 = vec4<f32>(_S6 * _S7, _S8 * _S7, _S6 * _S9, _S8 * _S9);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var place_2 : vec2<f32> = uv_0.value_1 * vec2<f32>(f32(width_0), f32(height_0));
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_2.y), height_0, wrap_1);
        var _S10 : u32 = row_0 * u32(width_0);
        var _S11 : u32 = wrapped_0(floor_of_0(place_2.x), width_0, wrap_1);
        return one_texel_0(_S10 + _S11);
    }
    var centred_0 : Point_0;
    var _S12 : vec2<f32> = place_2 - vec2<f32>(0.5f);
    centred_0.value_1 = _S12;
    var x_1 : i32 = floor_of_0(_S12.x);
    var y_0 : i32 = floor_of_0(_S12.y);
    var _S13 : u32 = wrapped_0(y_0, height_0, wrap_1);
    var _S14 : u32 = u32(width_0);
    var first_1 : u32 = _S13 * _S14;
    var _S15 : u32 = wrapped_0(y_0 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S15 * _S14;
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
    var record_0 : u32 = triangle_record_0(place_3.triangle_0) + u32(1);
    if(kind_0 == u32(4))
    {
        return one_texel_0(word_0(record_0));
    }
    if(kind_0 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_0 + u32(1)), word_0(record_0 + u32(2)), word_0(record_0 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_3.v_0 - place_3.w_0, place_3.v_0, place_3.w_0, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_3.triangle_0);
    var rows_0 : u32 = texture_1 + u32(6);
    var uv_1 : Point_0;
    var _S16 : vec3<f32> = vec3<f32>(uvs_1.a_0 * vec2<f32>((1.0f - place_3.v_0 - place_3.w_0)) + uvs_1.b_0 * vec2<f32>(place_3.v_0) + uvs_1.c_0 * vec2<f32>(place_3.w_0), 1.0f);
    uv_1.value_1 = vec2<f32>(dot(_S16, vector_at_0(rows_0)), dot(_S16, vector_at_0(rows_0 + u32(3))));
    if(kind_0 == u32(1))
    {
        var _S17 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S17;
    }
    var half_of_period_0 : vec2<f32> = uv_1.value_1 - floor(uv_1.value_1);
    var _S18 : i32;
    if(((half_of_period_0.x) > 0.5f) != ((half_of_period_0.y) > 0.5f))
    {
        _S18 = i32(1);
    }
    else
    {
        _S18 = i32(0);
    }
    return one_texel_0(u32(_S18));
}

fn change_word_0( at_4 : u32) -> u32
{
    return input_0[u32(12) * launch_0.room_0 + at_4];
}

fn numbers_of_0( texture_2 : u32) -> u32
{
    return change_word_0(u32(2) * word_0(texture_2 + u32(12)));
}

fn units_of_0( texture_3 : u32) -> f32
{
    return (bitcast<f32>((change_word_0(u32(2) * word_0(texture_3 + u32(12)) + u32(1)))));
}

fn add_word_0( sum_0 : u32,  word_of_sum_0 : u32,  number_1 : u32,  is_negative_0 : bool)
{
    var _S19 : u32 = u32(2) + u32(4) * sum_0;
    var _S20 : u32 = number_1;
    var k_1 : u32 = word_of_sum_0;
    for(;;)
    {
        var _S21 : bool;
        if(k_1 < u32(4))
        {
            _S21 = _S20 != u32(0);
        }
        else
        {
            _S21 = false;
        }
        if(_S21)
        {
        }
        else
        {
            break;
        }
        var _S22 : u32;
        if(is_negative_0)
        {
            _S22 = u32(0) - _S20;
        }
        else
        {
            _S22 = _S20;
        }
        var before_0 : u32 = atomicAdd(&(sums_0[_S19 + k_1]), _S22);
        var overflows_0 : bool;
        if(is_negative_0)
        {
            overflows_0 = before_0 < _S20;
        }
        else
        {
            overflows_0 = (before_0 + _S20) < before_0;
        }
        var _S23 : i32;
        if(overflows_0)
        {
            _S23 = i32(1);
        }
        else
        {
            _S23 = i32(0);
        }
        var _S24 : u32 = u32(_S23);
        var _S25 : u32 = k_1 + u32(1);
        _S20 = _S24;
        k_1 = _S25;
    }
    return;
}

fn add_to_sum_0( sum_1 : u32,  derivative_0 : f32,  units_0 : f32)
{
    if(!((abs(derivative_0)) < 3.00000000549775576e+38f))
    {
        var _S26 : u32 = atomicAdd(&(sums_0[u32(1)]), u32(1));
        return;
    }
    var scaled_0 : f32 = derivative_0 * units_0;
    var size_0 : f32 = abs(scaled_0);
    if(size_0 > 7.73712524553362672e+25f)
    {
        var _S27 : u32 = atomicAdd(&(sums_0[u32(0)]), u32(1));
        return;
    }
    var is_negative_1 : bool = scaled_0 < 0.0f;
    var highest_0 : u32 = u32(0);
    var size_1 : f32 = size_0;
    for(;;)
    {
        var _S28 : bool;
        if(highest_0 < u32(2))
        {
            _S28 = size_1 >= 4.294967296e+09f;
        }
        else
        {
            _S28 = false;
        }
        if(_S28)
        {
        }
        else
        {
            break;
        }
        var size_2 : f32 = size_1 * 2.32830643653869629e-10f;
        highest_0 = highest_0 + u32(1);
        size_1 = size_2;
    }
    var _S29 : bool = highest_0 == u32(0);
    var _S30 : f32;
    if(_S29)
    {
        _S30 = size_1 + 0.5f;
    }
    else
    {
        _S30 = size_1;
    }
    var whole_0 : u32 = u32(_S30);
    add_word_0(sum_1, highest_0, whole_0, is_negative_1);
    if(_S29)
    {
        return;
    }
    var rest_0 : f32 = (size_1 - f32(whole_0)) * 4.294967296e+09f;
    var _S31 : u32 = highest_0 - u32(1);
    if(highest_0 == u32(1))
    {
        size_1 = rest_0 + 0.5f;
    }
    else
    {
        size_1 = rest_0;
    }
    add_word_0(sum_1, _S31, u32(size_1), is_negative_1);
    return;
}

fn add_to_texels_0( texture_4 : u32,  lookup_3 : Lookup_0,  derivative_1 : vec3<f32>)
{
    var first_2 : u32 = numbers_of_0(texture_4);
    if(first_2 == u32(4294967295))
    {
        return;
    }
    var _S32 : f32 = units_of_0(texture_4);
    var _S33 : u32 = word_0(texture_4 + u32(1));
    var k_2 : u32 = u32(0);
    for(;;)
    {
        if(k_2 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_5 : u32 = first_2 + _S33 * lookup_3.texels_0[k_2];
        var own_0 : vec3<f32> = derivative_1 * vec3<f32>(lookup_3.weights_0[k_2]);
        if(_S33 == u32(1))
        {
            add_to_sum_0(at_5, own_0.x + own_0.y + own_0.z, _S32);
            k_2 = k_2 + u32(1);
            continue;
        }
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
            add_to_sum_0(at_5 + axis_0, own_0[axis_0], _S32);
            axis_0 = axis_0 + u32(1);
        }
        k_2 = k_2 + u32(1);
    }
    return;
}

fn set_word_0( path_4 : u32,  which_4 : u32,  value_2 : u32)
{
    paths_0[which_4 * launch_0.room_0 + path_4] = value_2;
    return;
}

fn set_vector_0( path_5 : u32,  which_5 : ptr<function, u32>,  value_3 : vec3<f32>)
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
        set_word_0(path_5, (*which_5) + axis_1, (bitcast<u32>((value_3[axis_1]))));
        axis_1 = axis_1 + u32(1);
    }
    (*which_5) = (*which_5) + u32(3);
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn go_back(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var at_6 : u32 = launch_0.first_0 + thread_0.x;
    if(at_6 >= (launch_0.end_0))
    {
        return;
    }
    var number_of_path_0 : u32 = input_0[at_6];
    var kept_0 : u32 = kept_at_0();
    var _S34 : vec3<f32> = path_vector_0(number_of_path_0, &(kept_0));
    var _S35 : Place_0 = path_place_0(number_of_path_0, &(kept_0));
    var _S36 : u32 = kept_0;
    kept_0 = kept_0 + u32(1);
    var _S37 : u32 = path_word_0(number_of_path_0, _S36);
    var direct_0 : Colour_0 = path_colour_0(number_of_path_0, &(kept_0));
    var onward_0 : Colour_0 = path_colour_0(number_of_path_0, &(kept_0));
    var which_6 : u32 = u32(15);
    var beyond_0 : vec3<f32> = path_vector_0(number_of_path_0, &(which_6));
    var slot_0 : u32 = u32(0);
    for(;;)
    {
        var _S38 : bool;
        if(slot_0 < u32(2))
        {
            _S38 = _S37 != u32(4294967295);
        }
        else
        {
            _S38 = false;
        }
        var _S39 : bool;
        if(_S38)
        {
            _S39 = slot_0 < (word_0(_S37 + u32(4)));
        }
        else
        {
            _S39 = false;
        }
        if(_S39)
        {
        }
        else
        {
            break;
        }
        var texture_5 : u32 = word_0(_S37 + u32(5) + slot_0);
        if(texture_5 == u32(4294967295))
        {
            slot_0 = slot_0 + u32(1);
            continue;
        }
        var change_0 : vec3<f32> = direct_0.changes_0[slot_0] + onward_0.changes_0[slot_0] * beyond_0;
        var _S40 : Lookup_0 = lookup_at_0(texture_5, _S35);
        add_to_texels_0(texture_5, _S40, _S34 * change_0);
        slot_0 = slot_0 + u32(1);
    }
    which_6 = u32(15);
    set_vector_0(number_of_path_0, &(which_6), direct_0.value_0 + onward_0.value_0 * beyond_0);
    return;
}
