// Compiled from render.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: eaa2832f82c845bd
// result: 90394118a5392dfa

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

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

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

fn path_changing_0( path_3 : u32,  which_3 : ptr<function, u32>) -> vec3<f32>
{
    var value_0 : vec3<f32> = path_vector_1(path_3, &((*which_3)));
    return value_0;
}

struct Place_0
{
     triangle_0 : u32,
     v_0 : f32,
     w_0 : f32,
     v_rest_0 : f32,
     w_rest_0 : f32,
};

fn exact_place_0( triangle_1 : u32,  v_1 : f32,  w_1 : f32) -> Place_0
{
    var place_0 : Place_0;
    place_0.triangle_0 = triangle_1;
    place_0.v_0 = v_1;
    place_0.w_0 = w_1;
    place_0.v_rest_0 = 0.0f;
    place_0.w_rest_0 = 0.0f;
    return place_0;
}

fn path_place_0( path_4 : u32,  which_4 : ptr<function, u32>) -> Place_0
{
    var _S3 : u32 = (*which_4) + u32(5);
    (*which_4) = _S3;
    return exact_place_0(path_word_0(path_4, _S3 - u32(5)), (bitcast<f32>((path_word_0(path_4, _S3 - u32(4))))) + (bitcast<f32>((path_word_0(path_4, _S3 - u32(2))))), (bitcast<f32>((path_word_0(path_4, _S3 - u32(3))))) + (bitcast<f32>((path_word_0(path_4, _S3 - u32(1))))));
}

struct Path_0
{
     throughput_0 : vec3<f32>,
     direction_0 : vec3<f32>,
     place_1 : Place_0,
     key_0 : vec2<u32>,
     direction_rest_0 : vec3<f32>,
     light_0 : vec3<f32>,
};

fn load_0( number_of_path_0 : u32) -> Path_0
{
    var at_0 : u32 = u32(1);
    var path_5 : Path_0;
    var _S4 : vec3<f32> = path_changing_0(number_of_path_0, &(at_0));
    path_5.light_0 = _S4;
    var _S5 : vec3<f32> = path_changing_0(number_of_path_0, &(at_0));
    path_5.throughput_0 = _S5;
    var _S6 : vec3<f32> = path_changing_0(number_of_path_0, &(at_0));
    path_5.direction_0 = _S6;
    var _S7 : Place_0 = path_place_0(number_of_path_0, &(at_0));
    path_5.place_1 = _S7;
    path_5.key_0 = vec2<u32>(path_word_0(number_of_path_0, at_0), path_word_0(number_of_path_0, at_0 + u32(1)));
    at_0 = at_0 + u32(2);
    var _S8 : vec3<f32> = path_vector_0(number_of_path_0, &(at_0));
    path_5.direction_rest_0 = _S8;
    return path_5;
}

fn changing_0( value_1 : vec3<f32>,  change_0 : vec3<f32>) -> vec3<f32>
{
    return value_1;
}

fn still_0( value_2 : vec3<f32>) -> vec3<f32>
{
    return changing_0(value_2, vec3<f32>(0.0f));
}

struct Reflected_0
{
     direct_0 : vec3<f32>,
     onward_0 : vec3<f32>,
};

fn nothing_reflected_0() -> Reflected_0
{
    var reflected_0 : Reflected_0;
    var _S9 : vec3<f32> = still_0(vec3<f32>(0.0f));
    reflected_0.direct_0 = _S9;
    reflected_0.onward_0 = _S9;
    return reflected_0;
}

fn word_0( at_1 : u32) -> u32
{
    return scene_0[at_1];
}

fn vertex_numbers_0( depth_1 : u32) -> u32
{
    return word_0(u32(7)) + depth_1 * (u32(3) * word_0(u32(2)) + u32(3) * word_0(u32(3)) + u32(1));
}

fn value_of_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vector_0;
}

fn triangle_record_0( triangle_2 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_2;
}

fn shape_of_0( triangle_3 : u32) -> u32
{
    return word_0(u32(10)) + u32(7) * word_0(triangle_record_0(triangle_3));
}

fn primitive_vector_0( at_2 : u32) -> vec3<f32>
{
    return vec3<f32>(primitives_0[at_2], primitives_0[at_2 + u32(1)], primitives_0[at_2 + u32(2)]);
}

fn position_of_0( place_2 : Place_0) -> vec3<f32>
{
    var at_3 : u32 = u32(9) * place_2.triangle_0;
    var a_0 : vec3<f32> = primitive_vector_0(at_3);
    return a_0 + (primitive_vector_0(at_3 + u32(3)) - a_0) * vec3<f32>((place_2.v_0 + place_2.v_rest_0)) + (primitive_vector_0(at_3 + u32(6)) - a_0) * vec3<f32>((place_2.w_0 + place_2.w_rest_0));
}

fn cross_of_0( triangle_4 : u32) -> vec3<f32>
{
    var at_4 : u32 = u32(9) * triangle_4;
    var a_1 : vec3<f32> = primitive_vector_0(at_4);
    return cross(primitive_vector_0(at_4 + u32(3)) - a_1, primitive_vector_0(at_4 + u32(6)) - a_1);
}

fn unit_0( v_2 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_2 / vec3<f32>(max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z))));
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

fn material_of_0( surface_1 : Surface_0) -> u32
{
    var _S12 : u32;
    if(surface_1.is_front_0)
    {
        _S12 = u32(2);
    }
    else
    {
        _S12 = u32(3);
    }
    return word_0(surface_1.shape_0 + _S12);
}

struct Numbers_0
{
     diffuse_reflectance_0 : vec3<f32>,
     specular_reflectance_0 : vec3<f32>,
     eta_0 : vec3<f32>,
     k_0 : vec3<f32>,
     alpha_0 : vec2<f32>,
};

fn no_numbers_0() -> Numbers_0
{
    var numbers_0 : Numbers_0;
    var _S13 : vec3<f32> = vec3<f32>(0.0f);
    numbers_0.k_0 = _S13;
    numbers_0.eta_0 = _S13;
    numbers_0.specular_reflectance_0 = _S13;
    numbers_0.diffuse_reflectance_0 = _S13;
    numbers_0.alpha_0 = vec2<f32>(0.0f);
    return numbers_0;
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
     a_3 : vec2<f32>,
     b_1 : vec2<f32>,
     c_1 : vec2<f32>,
};

fn Corners2_x24init_0( a_4 : vec2<f32>,  b_2 : vec2<f32>,  c_2 : vec2<f32>) -> Corners2_0
{
    var _S14 : Corners2_0;
    _S14.a_3 = a_4;
    _S14.b_1 = b_2;
    _S14.c_1 = c_2;
    return _S14;
}

fn precise_0( at_7 : u32) -> f32
{
    return number_0(at_7) + number_0(at_7 + u32(1));
}

fn uvs_of_0( triangle_5 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f32>(0.0f, 0.0f), vec2<f32>(1.0f, 0.0f), vec2<f32>(0.0f, 1.0f));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_5) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_8 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_5) + u32(1));
    uvs_0.a_3 = vec2<f32>(precise_0(at_8), precise_0(at_8 + u32(2)));
    uvs_0.b_1 = vec2<f32>(precise_0(at_8 + u32(4)), precise_0(at_8 + u32(6)));
    uvs_0.c_1 = vec2<f32>(precise_0(at_8 + u32(8)), precise_0(at_8 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_9 : u32) -> vec3<f32>
{
    return vec3<f32>(precise_0(at_9), precise_0(at_9 + u32(2)), precise_0(at_9 + u32(4)));
}

fn floor_of_0( x_0 : f32) -> i32
{
    return i32(clamp(floor(x_0), -1.0e+09f, 1.0e+09f));
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
     value_3 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_5 : Point_0) -> Lookup_0
{
    var way_0 : vec2<f32> = place_5.value_3 - floor(place_5.value_3);
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - way_0;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S15 : f32 = back_0.x;
    var _S16 : f32 = back_0.y;
    var _S17 : f32 = way_0.x;
    var _S18 : f32 = way_0.y;
    lookup_1.weights_0 = vec4<f32>(_S15 * _S16, _S17 * _S16, _S15 * _S18, _S17 * _S18);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var place_6 : vec2<f32> = uv_0.value_3 * vec2<f32>(f32(width_0), f32(height_0));
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_6.y), height_0, wrap_1);
        var _S19 : u32 = row_0 * u32(width_0);
        var _S20 : u32 = wrapped_0(floor_of_0(place_6.x), width_0, wrap_1);
        return one_texel_0(_S19 + _S20);
    }
    var centred_0 : Point_0;
    var _S21 : vec2<f32> = place_6 - vec2<f32>(0.5f);
    centred_0.value_3 = _S21;
    var x_1 : i32 = floor_of_0(_S21.x);
    var y_0 : i32 = floor_of_0(_S21.y);
    var _S22 : u32 = wrapped_0(y_0, height_0, wrap_1);
    var _S23 : u32 = u32(width_0);
    var first_1 : u32 = _S22 * _S23;
    var _S24 : u32 = wrapped_0(y_0 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S24 * _S23;
    var left_0 : u32 = wrapped_0(x_1, width_0, wrap_1);
    var right_0 : u32 = wrapped_0(x_1 + i32(1), width_0, wrap_1);
    return between_0(vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_7 : Place_0) -> Lookup_0
{
    var kind_0 : u32 = word_0(texture_1);
    if(kind_0 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_1 : u32 = triangle_record_0(place_7.triangle_0) + u32(1);
    if(kind_0 == u32(4))
    {
        return one_texel_0(word_0(record_1));
    }
    if(kind_0 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_1 + u32(1)), word_0(record_1 + u32(2)), word_0(record_1 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_7.v_0 - place_7.w_0, place_7.v_0, place_7.w_0, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_7.triangle_0);
    var _S25 : u32 = texture_1 + u32(6);
    var uv_1 : Point_0;
    var _S26 : vec3<f32> = vec3<f32>(uvs_1.a_3 + (uvs_1.b_1 - uvs_1.a_3) * vec2<f32>((place_7.v_0 + place_7.v_rest_0)) + (uvs_1.c_1 - uvs_1.a_3) * vec2<f32>((place_7.w_0 + place_7.w_rest_0)), 1.0f);
    uv_1.value_3 = vec2<f32>(dot(_S26, row_at_0(_S25)), dot(_S26, row_at_0(_S25 + u32(6))));
    if(kind_0 == u32(1))
    {
        var _S27 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S27;
    }
    var half_of_period_0 : vec2<f32> = uv_1.value_3 - floor(uv_1.value_3);
    var _S28 : i32;
    if(((half_of_period_0.x) > 0.5f) != ((half_of_period_0.y) > 0.5f))
    {
        _S28 = i32(1);
    }
    else
    {
        _S28 = i32(0);
    }
    return one_texel_0(u32(_S28));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_1 : vec4<f32>) -> vec3<f32>
{
    var _S29 : u32 = word_0(texture_2 + u32(1));
    var _S30 : u32 = texture_2 + u32(19);
    var _S31 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_4 : vec3<f32> = _S31;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_10 : u32 = _S30 + _S29 * lookup_3.texels_0[k_1];
        var _S32 : vec3<f32>;
        if(_S29 == u32(1))
        {
            _S32 = vec3<f32>(number_0(at_10));
        }
        else
        {
            _S32 = vector_at_0(at_10);
        }
        var value_5 : vec3<f32> = value_4 + _S32 * vec3<f32>(weights_1[k_1]);
        k_1 = k_1 + u32(1);
        value_4 = value_5;
    }
    return value_4;
}

fn looked_up_0( texture_3 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> vec3<f32>
{
    return weighted_texels_0(texture_3, lookup_4, lookup_4.weights_0);
}

fn shown_0( texture_4 : u32,  place_8 : Place_0) -> vec3<f32>
{
    var _S33 : Lookup_0 = lookup_at_0(texture_4, place_8);
    return looked_up_0(texture_4, _S33, vec2<f32>(0.0f));
}

fn luminance_0( colour_0 : vec3<f32>) -> f32
{
    return dot(colour_0, vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f));
}

fn set_slot_0( numbers_1 : ptr<function, Numbers_0>,  slot_0 : u32,  value_6 : vec3<f32>)
{
    switch(slot_0)
    {
    case u32(0):
        {
            (*numbers_1).diffuse_reflectance_0 = value_6;
            break;
        }
    case u32(1):
        {
            (*numbers_1).specular_reflectance_0 = value_6;
            break;
        }
    case u32(2):
        {
            (*numbers_1).eta_0 = value_6;
            break;
        }
    case u32(3):
        {
            (*numbers_1).k_0 = value_6;
            break;
        }
    case u32(4):
        {
            (*numbers_1).alpha_0[i32(0)] = luminance_0(value_6);
            break;
        }
    default :
        {
            (*numbers_1).alpha_0[i32(1)] = luminance_0(value_6);
            break;
        }
    }
    return;
}

struct Lobe_0
{
     record_2 : u32,
     kind_1 : u32,
     distribution_0 : u32,
     numbers_2 : Numbers_0,
};

fn lobe_at_0( record_3 : u32,  place_9 : Place_0) -> Lobe_0
{
    var lobe_0 : Lobe_0;
    lobe_0.record_2 = record_3;
    var is_black_0 : bool = record_3 == u32(4294967295);
    lobe_0.kind_1 = u32(0);
    var _S34 : u32;
    if(is_black_0)
    {
        _S34 = u32(1);
    }
    else
    {
        _S34 = word_0(record_3 + u32(1));
    }
    lobe_0.distribution_0 = _S34;
    lobe_0.numbers_2 = no_numbers_0();
    if(is_black_0)
    {
        _S34 = u32(0);
    }
    else
    {
        _S34 = u32(1);
    }
    var slot_1 : u32 = u32(0);
    for(;;)
    {
        if(slot_1 < _S34)
        {
        }
        else
        {
            break;
        }
        var texture_5 : u32 = word_0(record_3 + u32(5) + slot_1);
        if(texture_5 == u32(4294967295))
        {
            slot_1 = slot_1 + u32(1);
            continue;
        }
        var colour_1 : vec3<f32> = shown_0(texture_5, place_9);
        var _S35 : vec3<f32> = value_of_0(colour_1);
        var _S36 : Numbers_0 = lobe_0.numbers_2;
        set_slot_0(&(_S36), slot_1, _S35);
        lobe_0.numbers_2 = _S36;
        slot_1 = slot_1 + u32(1);
    }
    return lobe_0;
}

fn tangent_at_0( surface_2 : Surface_0) -> vec3<f32>
{
    var tangents_0 : u32 = word_0(surface_2.shape_0 + u32(5));
    if(tangents_0 == u32(4294967295))
    {
        return vec3<f32>(0.0f);
    }
    var tangent_0 : vec3<f32> = vector_at_0(tangents_0 + u32(3) * word_0(triangle_record_0(surface_2.place_3.triangle_0) + u32(1)));
    var across_0 : vec3<f32> = cross(tangent_0, surface_2.outward_0);
    var _S37 : vec3<f32>;
    if((dot(across_0, across_0)) > 0.0f)
    {
        _S37 = tangent_0;
    }
    else
    {
        _S37 = vec3<f32>(0.0f);
    }
    return _S37;
}

struct Axes_0
{
     s_0 : vec3<f32>,
     t_0 : vec3<f32>,
     n_1 : vec3<f32>,
};

fn axes_along_0( n_2 : vec3<f32>,  tangent_1 : vec3<f32>,  is_front_1 : bool) -> Axes_0
{
    var axes_0 : Axes_0;
    var _S38 : vec3<f32>;
    if(is_front_1)
    {
        _S38 = n_2;
    }
    else
    {
        _S38 = (vec3<f32>(0) - n_2);
    }
    axes_0.n_1 = _S38;
    var _S39 : vec3<f32> = normalize(tangent_1 - n_2 * vec3<f32>(dot(n_2, tangent_1)));
    axes_0.s_0 = _S39;
    axes_0.t_0 = cross(n_2, _S39);
    return axes_0;
}

fn axes_around_0( n_3 : vec3<f32>,  is_front_2 : bool) -> Axes_0
{
    var axes_1 : Axes_0;
    var _S40 : vec3<f32>;
    if(is_front_2)
    {
        _S40 = n_3;
    }
    else
    {
        _S40 = (vec3<f32>(0) - n_3);
    }
    axes_1.n_1 = _S40;
    var _S41 : f32 = n_3.z;
    var sign_0 : f32;
    if(_S41 < -0.00000999999974738f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var a_5 : f32 = -1.0f / (sign_0 + _S41);
    var _S42 : f32 = n_3.x;
    var _S43 : f32 = n_3.y;
    var b_3 : f32 = _S42 * _S43 * a_5;
    axes_1.s_0 = vec3<f32>(1.0f + sign_0 * _S42 * _S42 * a_5, sign_0 * b_3, - sign_0 * _S42);
    axes_1.t_0 = vec3<f32>(b_3, sign_0 + _S43 * _S43 * a_5, - _S43);
    return axes_1;
}

fn to_local_0( axes_2 : Axes_0,  v_3 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(axes_2.s_0, v_3), dot(axes_2.t_0, v_3), dot(axes_2.n_1, v_3));
}

fn towards_viewer_0( axes_3 : Axes_0,  direction_2 : vec3<f32>) -> vec3<f32>
{
    var wi_0 : vec3<f32> = (vec3<f32>(0) - to_local_0(axes_3, direction_2));
    return vec3<f32>(wi_0.x, wi_0.y, max(abs(wi_0.z), 9.999999960041972e-13f));
}

struct Vertex_0
{
     surface_3 : Surface_0,
     axes_4 : Axes_0,
     lobe_1 : Lobe_0,
     wi_1 : vec3<f32>,
};

fn vertex_at_0( surface_4 : Surface_0,  material_0 : u32,  direction_3 : vec3<f32>) -> Vertex_0
{
    var vertex_0 : Vertex_0;
    vertex_0.surface_3 = surface_4;
    var _S44 : Lobe_0 = lobe_at_0(material_0, surface_4.place_3);
    vertex_0.lobe_1 = _S44;
    var tangent_2 : vec3<f32> = tangent_at_0(surface_4);
    if((any((tangent_2 != vec3<f32>(0.0f)))))
    {
        vertex_0.axes_4 = axes_along_0(surface_4.outward_0, tangent_2, surface_4.is_front_0);
    }
    else
    {
        vertex_0.axes_4 = axes_around_0(surface_4.outward_0, surface_4.is_front_0);
    }
    vertex_0.wi_1 = towards_viewer_0(vertex_0.axes_4, direction_3);
    return vertex_0;
}

fn reaches_0( segments_0 : u32) -> bool
{
    return segments_0 <= (word_0(u32(0)));
}

fn emitter_record_0( emitter_0 : u32) -> u32
{
    return word_0(u32(11)) + u32(12) * emitter_0;
}

fn is_area_0( record_4 : u32) -> bool
{
    return (word_0(record_4)) == u32(0);
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
    var _S45 : f32 = min(highest_0, 1.0f);
    return area_0 * _S45 * _S45 / (2.0f * (_S45 - max(lowest_0, -1.0f)) * squared_0);
}

fn is_sampled_well_0( position_1 : vec3<f32>) -> bool
{
    var _S46 : bool;
    if((word_0(u32(6))) != u32(1))
    {
        _S46 = true;
    }
    else
    {
        _S46 = (word_0(u32(2))) == u32(0);
    }
    if(_S46)
    {
        return false;
    }
    var record_5 : u32 = emitter_record_0(u32(0));
    if(is_area_0(record_5))
    {
        _S46 = (node_seen_0(word_0(record_5 + u32(5)), position_1)) < 1.0f;
    }
    else
    {
        _S46 = false;
    }
    return _S46;
}

fn has_smooth_0( lobe_2 : Lobe_0) -> bool
{
    return (lobe_2.kind_1) != u32(1);
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
    var record_6 : u32 = emitter_record_0(emitter_1);
    if(!is_area_0(record_6))
    {
        return 3.14159274101257324f;
    }
    return node_seen_0(word_0(record_6 + u32(5)), position_3) * largest_cosine_0(position_3, normal_1, vector_at_0(record_6 + u32(8)), number_0(record_6 + u32(11)));
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
    var _S47 : f32;
    if(view_0 > 0.0f)
    {
        _S47 = 1.0f;
    }
    else
    {
        _S47 = 0.0f;
    }
    (*can_light_0) = _S47;
    return view_0 * number_0(emitter_record_0(emitter_2) + u32(2));
}

fn light_of_1( emitter_3 : u32,  choice_1 : Choice_0,  can_light_1 : ptr<function, f32>) -> f32
{
    var view_1 : f32 = emitter_view_0(emitter_3, choice_1.position_4, choice_1.normal_2);
    var _S48 : f32;
    if(view_1 > 0.0f)
    {
        _S48 = 1.0f;
    }
    else
    {
        _S48 = 0.0f;
    }
    (*can_light_1) = _S48;
    return view_1 * number_0(emitter_record_0(emitter_3) + u32(2));
}

fn choice_at_0( position_5 : vec3<f32>,  normal_3 : vec3<f32>,  alike_0 : bool) -> Choice_0
{
    var choice_2 : Choice_0;
    choice_2.position_4 = position_5;
    choice_2.normal_2 = normal_3;
    choice_2.all_0 = 0.0f;
    choice_2.lit_0 = 0.0f;
    var count_1 : u32 = word_0(u32(6));
    var _S49 : bool;
    if(alike_0)
    {
        _S49 = true;
    }
    else
    {
        _S49 = (word_0(u32(5))) != u32(0);
    }
    if(_S49)
    {
        _S49 = true;
    }
    else
    {
        _S49 = count_1 < u32(2);
    }
    if(_S49)
    {
        _S49 = true;
    }
    else
    {
        _S49 = count_1 > u32(32);
    }
    if(_S49)
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
        var _S50 : f32 = light_of_1(i_1, choice_2, &(can_light_2));
        choice_2.all_0 = choice_2.all_0 + _S50;
        choice_2.lit_0 = choice_2.lit_0 + can_light_2;
        i_1 = i_1 + u32(1);
    }
    if((choice_2.all_0) > 0.0f)
    {
        _S49 = (choice_2.all_0) < 3.00000000549775576e+38f;
    }
    else
    {
        _S49 = false;
    }
    if(!_S49)
    {
        choice_2.all_0 = 0.0f;
    }
    return choice_2;
}

fn limit_at_0( which_5 : u32) -> f32
{
    return primitives_0[word_0(u32(15)) + which_5];
}

fn product_0( a_6 : u32,  b_4 : u32) -> vec2<u32>
{
    var a0_0 : u32 = (a_6 & (u32(65535)));
    var a1_0 : u32 = (a_6 >> (u32(16)));
    var b0_0 : u32 = (b_4 & (u32(65535)));
    var b1_0 : u32 = (b_4 >> (u32(16)));
    var low_0 : u32 = a0_0 * b0_0;
    var middle_0 : u32 = a1_0 * b0_0 + ((low_0 >> (u32(16))));
    var rest_0 : u32 = ((middle_0 & (u32(65535)))) + a0_0 * b1_0;
    return vec2<u32>((((rest_0 << (u32(16)))) | (((low_0 & (u32(65535)))))), a1_0 * b1_0 + ((middle_0 >> (u32(16)))) + ((rest_0 >> (u32(16)))));
}

fn times_0( a_7 : vec2<u32>,  b_5 : vec2<u32>) -> vec2<u32>
{
    var _S51 : u32 = a_7.x;
    var _S52 : u32 = b_5.x;
    var low_1 : vec2<u32> = product_0(_S51, _S52);
    return vec2<u32>(low_1.x, low_1.y + _S51 * b_5.y + a_7.y * _S52);
}

fn plus_0( a_8 : vec2<u32>,  b_6 : vec2<u32>) -> vec2<u32>
{
    var _S53 : u32 = a_8.x;
    var low_2 : u32 = _S53 + b_6.x;
    var _S54 : u32 = a_8.y + b_6.y;
    var _S55 : i32;
    if(low_2 < _S53)
    {
        _S55 = i32(1);
    }
    else
    {
        _S55 = i32(0);
    }
    return vec2<u32>(low_2, _S54 + u32(_S55));
}

fn shifted_xor_0( x_2 : vec2<u32>,  by_0 : u32) -> vec2<u32>
{
    var _S56 : u32 = x_2.y;
    return (x_2 ^ (vec2<u32>(((((x_2.x) >> (by_0))) | (((_S56 << ((u32(32) - by_0)))))), (_S56 >> (by_0)))));
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
        var _S57 : f32 = f32(count_2);
        (*probability_0) = 1.0f / _S57;
        return min(u32(u_0 * _S57), count_2 - u32(1));
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
        var _S58 : u32 = i_2 + u32(1);
        found_0 = found_1;
        i_2 = _S58;
        rest_1 = rest_2;
    }
    return found_0;
}

fn place_at_0( triangle_6 : u32,  v_4 : f32,  w_2 : f32) -> Place_0
{
    return exact_place_0(triangle_6, v_4, w_2);
}

fn angle_of_0( x_4 : f32,  y_1 : f32) -> f32
{
    var _S59 : f32 = abs(x_4);
    var _S60 : f32 = abs(y_1);
    var _S61 : f32 = min(_S59, _S60);
    var _S62 : f32 = max(_S59, _S60);
    var is_steep_0 : bool = _S61 > (0.41421356797218323f * _S62);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S61 - _S62;
    }
    else
    {
        above_0 = _S61;
    }
    var below_0 : f32;
    if(is_steep_0)
    {
        below_0 = _S61 + _S62;
    }
    else
    {
        below_0 = _S62;
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
    if(_S60 > _S59)
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

fn solid_angle_of_0( a_9 : vec3<f32>,  b_7 : vec3<f32>,  c_3 : vec3<f32>) -> f32
{
    var la_0 : f32 = length(a_9);
    var lb_0 : f32 = length(b_7);
    var lc_0 : f32 = length(c_3);
    var normal_4 : vec3<f32> = cross(b_7 - a_9, c_3 - a_9);
    var volume_0 : f32 = - dot(a_9, normal_4);
    if(!(volume_0 > (9.99999997475242708e-07f * max(max(la_0, lb_0), lc_0) * length(normal_4))))
    {
        return 0.0f;
    }
    return 2.0f * angle_of_0(la_0 * lb_0 * lc_0 + dot(a_9, b_7) * lc_0 + dot(b_7, c_3) * la_0 + dot(c_3, a_9) * lb_0, volume_0);
}

fn complex_product_0( a_10 : vec2<f32>,  b_8 : vec2<f32>) -> vec2<f32>
{
    var _S63 : f32 = a_10.x;
    var _S64 : f32 = b_8.x;
    var _S65 : f32 = a_10.y;
    var _S66 : f32 = b_8.y;
    return vec2<f32>(_S63 * _S64 - _S65 * _S66, _S63 * _S66 + _S65 * _S64);
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
    var _S67 : f32 = - dot(vector_at_0(at_11 + u32(9)), offset_2);
    seen_1.z_1 = _S67;
    var a_11 : vec3<f32> = vec3<f32>(x0_0, y0_0, _S67);
    var b_9 : vec3<f32> = vec3<f32>(x1_0, y0_0, _S67);
    var c_4 : vec3<f32> = vec3<f32>(x0_0, y1_0, _S67);
    var d_0 : vec3<f32> = vec3<f32>(x1_0, y1_0, _S67);
    var _S68 : f32 = length(a_11);
    var _S69 : f32 = length(c_4);
    var _S70 : f32;
    if(_S67 > (9.99999997475242708e-07f * max(max(_S68, length(b_9)), max(_S69, length(d_0)))))
    {
        _S70 = solid_angle_of_0(a_11, c_4, b_9) + solid_angle_of_0(d_0, b_9, c_4);
    }
    else
    {
        _S70 = 0.0f;
    }
    seen_1.solid_angle_0 = _S70;
    var z2_0 : f32 = seen_1.z_1 * seen_1.z_1;
    var at_first_0 : vec2<f32> = complex_product_0(vec2<f32>(x0_0 * y1_0, seen_1.z_1 * _S69), vec2<f32>(- x0_0 * y0_0, seen_1.z_1 * _S68));
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
    var _S71 : f32 = seen_2.y_2.x;
    var _S72 : f32 = seen_2.inverse_to_line_0.x;
    var _S73 : f32 = seen_2.y_2.y;
    var n_4 : f32 = - at_12.x * _S71 * _S72 - _S73 * seen_2.inverse_to_line_0.y;
    var _S74 : f32 = at_12.y;
    var flat_0 : f32 = _S74 * seen_2.z_1 * _S72;
    var size_0 : f32 = seen_2.z_1 * abs(_S74) / sqrt(max(n_4 * n_4 - flat_0 * flat_0, 0.0f));
    var _S75 : f32;
    if((n_4 * _S74) < 0.0f)
    {
        _S75 = - size_0;
    }
    else
    {
        _S75 = size_0;
    }
    var x_7 : f32 = clamp(_S75, seen_2.x_5.x, seen_2.x_5.y);
    var squared_1 : f32 = x_7 * x_7 + seen_2.z_1 * seen_2.z_1;
    var h_0 : vec2<f32> = seen_2.y_2 / sqrt(vec2<f32>(squared_1) + seen_2.y_2 * seen_2.y_2);
    var _S76 : f32 = h_0.x;
    var sine_2 : f32 = _S76 + u_1.y * (h_0.y - _S76);
    return vec2<f32>(x_7, clamp(sine_2 * sqrt(squared_1 / max((1.0f - sine_2) * (1.0f + sine_2), 0.0f)), _S71, _S73));
}

fn rectangle_face_0( at_13 : u32,  place_10 : vec2<f32>,  weights_2 : ptr<function, vec2<f32>>) -> u32
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
        var _S77 : f32 = place_10.x;
        var _S78 : f32 = place_10.y;
        var v_5 : f32 = number_0(row_1) + number_0(row_1 + u32(1)) * _S77 + number_0(row_1 + u32(2)) * _S78;
        var w_3 : f32 = number_0(row_1 + u32(3)) + number_0(row_1 + u32(4)) * _S77 + number_0(row_1 + u32(5)) * _S78;
        var _S79 : f32 = min(min(v_5, w_3), 1.0f - v_5 - w_3);
        if(_S79 > best_0)
        {
            (*weights_2)[i32(0)] = clamp(v_5, 0.0f, 1.0f);
            (*weights_2)[i32(1)] = clamp(w_3, 0.0f, 1.0f - (*weights_2).x);
            best_0 = _S79;
            found_2 = face_0;
        }
        face_0 = face_0 + u32(1);
    }
    return found_2;
}

fn emitter_triangle_0( record_7 : u32,  face_1 : u32) -> u32
{
    return word_0(word_0(u32(12)) + word_0(record_7 + u32(3)) + face_1);
}

fn precise_random_0( key_3 : vec2<u32>,  dimension_2 : u32) -> f32
{
    return f32(((random_bits_0(key_3, dimension_2).y) >> (u32(8)))) / 4096.0f / 4096.0f;
}

fn shares_of_0( nodes_at_0 : u32,  node_1 : u32,  viewpoint_2 : vec3<f32>) -> vec2<f32>
{
    var _S80 : f32 = node_seen_0(nodes_at_0 + u32(17) * word_0(node_1 + u32(2)), viewpoint_2);
    var _S81 : f32 = node_seen_0(nodes_at_0 + u32(17) * word_0(node_1 + u32(3)), viewpoint_2);
    var seen_3 : vec2<f32> = vec2<f32>(_S80, _S81);
    var sum_0 : f32 = _S80 + _S81;
    var _S82 : vec2<f32>;
    if(sum_0 > 0.0f)
    {
        _S82 = seen_3 / vec2<f32>(sum_0);
    }
    else
    {
        _S82 = vec2<f32>(0.0f);
    }
    return _S82;
}

struct Corners_0
{
     a_12 : vec3<f32>,
     b_10 : vec3<f32>,
     c_5 : vec3<f32>,
};

fn corners_from_0( record_8 : u32,  face_2 : u32,  viewpoint_3 : vec3<f32>) -> Corners_0
{
    var at_14 : u32 = u32(9) * emitter_triangle_0(record_8, face_2);
    var corners_0 : Corners_0;
    corners_0.a_12 = primitive_vector_0(at_14) - viewpoint_3;
    corners_0.b_10 = primitive_vector_0(at_14 + u32(3)) - viewpoint_3;
    corners_0.c_5 = primitive_vector_0(at_14 + u32(6)) - viewpoint_3;
    return corners_0;
}

fn face_solid_angle_0( record_9 : u32,  face_3 : u32,  viewpoint_4 : vec3<f32>) -> f32
{
    var corners_1 : Corners_0 = corners_from_0(record_9, face_3, viewpoint_4);
    return solid_angle_of_0(corners_1.a_12, corners_1.b_10, corners_1.c_5);
}

fn unit_across_0( v_6 : vec3<f32>,  axis_1 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_6 - axis_1 * vec3<f32>(dot(v_6, axis_1)));
}

fn along_0( from_0 : vec3<f32>,  to_0 : vec3<f32>,  cosine_3 : f32) -> vec3<f32>
{
    var _S83 : f32 = clamp(cosine_3, -1.0f, 1.0f);
    return from_0 * vec3<f32>(_S83) + unit_across_0(to_0, from_0) * vec3<f32>(sqrt((1.0f - _S83) * (1.0f + _S83)));
}

fn triangle_direction_0( a_13 : vec3<f32>,  b_11 : vec3<f32>,  c_6 : vec3<f32>,  area_1 : f32,  u_2 : vec2<f32>) -> vec3<f32>
{
    var _S84 : vec3<f32> = normalize(a_13);
    var _S85 : vec3<f32> = normalize(b_11);
    var _S86 : vec3<f32> = normalize(c_6);
    var ab_0 : vec3<f32> = normalize(cross(_S84, _S85));
    var ca_0 : vec3<f32> = normalize(cross(_S86, _S84));
    var sine_alpha_0 : f32 = length(cross(ab_0, ca_0));
    var cosine_alpha_0 : f32 = - dot(ab_0, ca_0);
    var part_0 : vec2<f32> = sine_cosine_0(u_2.x * area_1);
    var _S87 : f32 = part_0.x;
    var _S88 : f32 = part_0.y;
    var sine_phi_0 : f32 = _S87 * cosine_alpha_0 - _S88 * sine_alpha_0;
    var cosine_phi_0 : f32 = _S88 * cosine_alpha_0 + _S87 * sine_alpha_0;
    var k1_0 : f32 = cosine_phi_0 - cosine_alpha_0;
    var k2_0 : f32 = sine_phi_0 + sine_alpha_0 * dot(_S84, _S85);
    var between_1 : vec3<f32> = along_0(_S84, _S86, ((k2_0 * cosine_phi_0 - k1_0 * sine_phi_0) * cosine_alpha_0 - k2_0) / ((k2_0 * sine_phi_0 + k1_0 * cosine_phi_0) * sine_alpha_0));
    return along_0(_S85, between_1, 1.0f - u_2.y * (1.0f - dot(between_1, _S85)));
}

fn density_of_0( solid_angle_1 : f32,  normal_5 : vec3<f32>,  distance_2 : f32,  direction_4 : vec3<f32>) -> f32
{
    if(!(solid_angle_1 < 0.00100000004749745f))
    {
        return 1.0f;
    }
    return solid_angle_1 * 2.0f * distance_2 * distance_2 / abs(dot(normal_5, direction_4));
}

struct EmitterPoint_0
{
     place_11 : Place_0,
     pdf_0 : f32,
};

fn area_point_0( record_10 : u32,  from_1 : Surface_0,  key_4 : vec2<u32>,  dimension_3 : u32) -> EmitterPoint_0
{
    var total_0 : f32;
    var point_0 : EmitterPoint_0;
    point_0.pdf_0 = 0.0f;
    point_0.place_11 = place_at_0(u32(0), 0.0f, 0.0f);
    var second_1 : f32 = random_0(key_4, dimension_3 + u32(1));
    var rectangle_0 : u32 = word_0(record_10 + u32(4));
    if(rectangle_0 != u32(4294967295))
    {
        var seen_4 : SeenRectangle_0 = seen_rectangle_0(rectangle_0, from_1.position_0);
        if(!((seen_4.solid_angle_0) > 0.0f))
        {
            return point_0;
        }
        if((seen_4.solid_angle_0) >= 0.00100000004749745f)
        {
            var weights_3 : vec2<f32>;
            var face_4 : u32 = rectangle_face_0(rectangle_0, rectangle_place_0(seen_4, vec2<f32>(random_0(key_4, dimension_3), second_1)) - vec2<f32>(seen_4.x_5.x, seen_4.y_2.x), &(weights_3));
            point_0.place_11.triangle_0 = emitter_triangle_0(record_10, face_4);
            point_0.place_11.v_0 = weights_3.x;
            point_0.place_11.w_0 = weights_3.y;
            point_0.pdf_0 = 1.0f / seen_4.solid_angle_0;
            return point_0;
        }
    }
    var _S89 : f32 = precise_random_0(key_4, dimension_3);
    var nodes_at_1 : u32 = word_0(record_10 + u32(5));
    var node_2 : u32 = nodes_at_1;
    var u_3 : f32 = _S89;
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
        var _S90 : f32 = shares_0.x;
        var _S91 : f32 = shares_0.y;
        if(!((_S90 + _S91) > 0.0f))
        {
            return point_0;
        }
        var is_second_0 : bool;
        if(u_3 >= _S90)
        {
            is_second_0 = _S91 > 0.0f;
        }
        else
        {
            is_second_0 = false;
        }
        if(is_second_0)
        {
            u_3 = (u_3 - _S90) / _S91;
        }
        else
        {
            u_3 = min(u_3 / _S90, 1.0f);
        }
        if(is_second_0)
        {
            total_0 = _S91;
        }
        else
        {
            total_0 = _S90;
        }
        var chosen_1 : f32 = chosen_0 * total_0;
        var _S92 : i32;
        if(is_second_0)
        {
            _S92 = i32(3);
        }
        else
        {
            _S92 = i32(2);
        }
        node_2 = nodes_at_1 + u32(17) * word_0(node_2 + u32(_S92));
        chosen_0 = chosen_1;
    }
    var first_2 : u32 = word_0(node_2);
    var _S93 : u32 = word_0(node_2 + u32(1));
    var _S94 : u32 = word_0(record_10 + u32(6));
    var k_2 : u32 = first_2;
    total_0 = 0.0f;
    for(;;)
    {
        if(k_2 < _S93)
        {
        }
        else
        {
            break;
        }
        var total_1 : f32 = total_0 + face_solid_angle_0(record_10, word_0(_S94 + k_2), from_1.exact_0);
        k_2 = k_2 + u32(1);
        total_0 = total_1;
    }
    var _S95 : f32 = u_3 * total_0;
    var face_5 : u32 = u32(4294967295);
    var angle_3 : f32 = 0.0f;
    var inside_2 : f32 = 0.0f;
    k_2 = first_2;
    var rest_3 : f32 = _S95;
    for(;;)
    {
        if(k_2 < _S93)
        {
        }
        else
        {
            break;
        }
        var _S96 : u32 = _S94 + k_2;
        var own_1 : f32 = face_solid_angle_0(record_10, word_0(_S96), from_1.exact_0);
        if(!(own_1 > 0.0f))
        {
            k_2 = k_2 + u32(1);
            continue;
        }
        var _S97 : u32 = word_0(_S96);
        var _S98 : f32 = min(rest_3 / own_1, 1.0f);
        if(rest_3 < own_1)
        {
            face_5 = _S97;
            angle_3 = own_1;
            inside_2 = _S98;
            break;
        }
        var rest_4 : f32 = rest_3 - own_1;
        face_5 = _S97;
        angle_3 = own_1;
        inside_2 = _S98;
        rest_3 = rest_4;
        k_2 = k_2 + u32(1);
    }
    if(face_5 == u32(4294967295))
    {
        return point_0;
    }
    var corners_2 : Corners_0 = corners_from_0(record_10, face_5, from_1.exact_0);
    var ab_1 : vec3<f32> = corners_2.b_10 - corners_2.a_12;
    var ac_0 : vec3<f32> = corners_2.c_5 - corners_2.a_12;
    var normal_6 : vec3<f32> = cross(ab_1, ac_0);
    point_0.place_11.triangle_0 = emitter_triangle_0(record_10, face_5);
    if(angle_3 < 0.00100000004749745f)
    {
        var root_0 : f32 = sqrt(inside_2);
        point_0.place_11.v_0 = root_0 * (1.0f - second_1);
        point_0.place_11.w_0 = root_0 * second_1;
    }
    else
    {
        var direction_5 : vec3<f32> = triangle_direction_0(corners_2.a_12, corners_2.b_10, corners_2.c_5, angle_3, vec2<f32>(inside_2, second_1));
        var within_0 : vec3<f32> = direction_5 * vec3<f32>((dot(corners_2.a_12, normal_6) / dot(direction_5, normal_6))) - corners_2.a_12;
        var squared_2 : f32 = dot(normal_6, normal_6);
        var _S99 : f32 = clamp(dot(cross(within_0, ac_0), normal_6) / squared_2, 0.0f, 1.0f);
        point_0.place_11.v_0 = _S99;
        point_0.place_11.w_0 = clamp(dot(cross(ab_1, within_0), normal_6) / squared_2, 0.0f, 1.0f - _S99);
    }
    var offset_3 : vec3<f32> = corners_2.a_12 + ab_1 * vec3<f32>(point_0.place_11.v_0) + ac_0 * vec3<f32>(point_0.place_11.w_0);
    var distance_3 : f32 = length(offset_3);
    if(!(distance_3 > 0.0f))
    {
        return point_0;
    }
    point_0.pdf_0 = chosen_0 / total_0 * density_of_0(angle_3, normal_6, distance_3, offset_3 / vec3<f32>(distance_3));
    return point_0;
}

fn is_map_0( record_11 : u32) -> bool
{
    return false;
}

fn uniform_direction_0( u_4 : vec2<f32>) -> vec3<f32>
{
    var _S100 : f32 = u_4.x;
    var turn_1 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_4.y) * vec2<f32>((2.0f * sqrt(_S100 * (1.0f - _S100))));
    return vec3<f32>(turn_1.y, turn_1.x, 1.0f - 2.0f * _S100);
}

fn map_place_0( map_0 : u32,  direction_6 : vec3<f32>) -> vec2<f32>
{
    var _S101 : u32 = map_0 + u32(2);
    var d_1 : vec3<f32> = vector_at_0(_S101) * vec3<f32>(direction_6.x) + vector_at_0(_S101 + u32(3)) * vec3<f32>(direction_6.y) + vector_at_0(_S101 + u32(6)) * vec3<f32>(direction_6.z);
    return vec2<f32>(angle_of_0(- d_1.z, d_1.x) * 0.15915493667125702f * f32(word_0(map_0)) - 0.5f, angle_of_0(d_1.y, length(d_1.xz)) * 0.31830987334251404f * (f32(word_0(map_0 + u32(1))) - 1.0f));
}

fn cell_pdf_0( map_1 : u32,  cell_0 : u32) -> f32
{
    return 0.00397887360304594f + 0.94999998807907104f * number_0(word_0(map_1 + u32(15)) + cell_0);
}

fn map_pdf_0( map_2 : u32,  direction_7 : vec3<f32>) -> f32
{
    if((word_0(map_2 + u32(13))) == u32(4294967295))
    {
        return 0.07957746833562851f;
    }
    var place_12 : vec2<f32> = map_place_0(map_2, direction_7);
    var width_1 : u32 = word_0(map_2);
    var column_0 : u32 = wrapped_0(floor_of_0(place_12.x), i32(width_1), u32(0));
    return cell_pdf_0(map_2, u32(clamp(floor_of_0(place_12.y), i32(0), i32(word_0(map_2 + u32(1))) - i32(2))) * width_1 + column_0);
}

fn chosen_interval_0( sums_1 : u32,  count_3 : u32,  u_5 : f32,  through_0 : ptr<function, f32>) -> u32
{
    var _S102 : u32 = count_3 - u32(1);
    var total_2 : f32 = precise_0(sums_1 + u32(2) * _S102);
    var target_0 : f32 = u_5 * total_2;
    var low_3 : u32 = u32(0);
    var high_0 : u32 = _S102;
    for(;;)
    {
        if(low_3 < high_0)
        {
        }
        else
        {
            break;
        }
        var middle_1 : u32 = (low_3 + high_0) / u32(2);
        var sum_1 : f32 = precise_0(sums_1 + u32(2) * middle_1);
        var _S103 : bool;
        if(sum_1 <= target_0)
        {
            _S103 = sum_1 < total_2;
        }
        else
        {
            _S103 = false;
        }
        if(_S103)
        {
            low_3 = middle_1 + u32(1);
        }
        else
        {
            high_0 = middle_1;
        }
    }
    var below_1 : f32;
    if(low_3 > u32(0))
    {
        below_1 = precise_0(sums_1 + u32(2) * (low_3 - u32(1)));
    }
    else
    {
        below_1 = 0.0f;
    }
    (*through_0) = clamp((target_0 - below_1) / (precise_0(sums_1 + u32(2) * low_3) - below_1), 0.0f, 1.0f);
    return low_3;
}

fn cell_direction_0( map_3 : u32,  column_1 : u32,  row_2 : u32,  along_1 : f32,  down_0 : f32) -> vec3<f32>
{
    var turns_0 : f32 = (f32(column_1) + 0.5f + along_1) / f32(word_0(map_3));
    var azimuth_0 : vec2<f32> = sine_cosine_0(6.28318548202514648f * (turns_0 - floor(turns_0 + 0.5f)));
    var last_0 : u32 = word_0(map_3 + u32(1)) - u32(1);
    var is_lower_0 : bool = (u32(2) * row_2) >= last_0;
    var rows_0 : vec2<f32>;
    if(is_lower_0)
    {
        var _S104 : u32 = last_0 - row_2;
        rows_0 = vec2<f32>(f32(_S104), f32(_S104 - u32(1)));
    }
    else
    {
        rows_0 = vec2<f32>(f32(row_2), f32(row_2 + u32(1)));
    }
    var _S105 : f32 = f32(last_0);
    var _S106 : f32 = sine_cosine_0(rows_0.x * (1.57079637050628662f / _S105)).x;
    var _S107 : f32 = sine_cosine_0(rows_0.y * (1.57079637050628662f / _S105)).x;
    var off_0 : f32 = 2.0f * mix(_S106 * _S106, _S107 * _S107, down_0);
    var sine_3 : f32 = sqrt(off_0 * (2.0f - off_0));
    var _S108 : f32 = azimuth_0.x * sine_3;
    var _S109 : f32;
    if(is_lower_0)
    {
        _S109 = off_0 - 1.0f;
    }
    else
    {
        _S109 = 1.0f - off_0;
    }
    var local_0 : vec3<f32> = vec3<f32>(_S108, _S109, - azimuth_0.y * sine_3);
    var _S110 : u32 = map_3 + u32(2);
    return vec3<f32>(dot(vector_at_0(_S110), local_0), dot(vector_at_0(_S110 + u32(3)), local_0), dot(vector_at_0(_S110 + u32(6)), local_0));
}

fn sample_map_0( map_4 : u32,  key_5 : vec2<u32>,  dimension_4 : u32,  pdf_1 : ptr<function, f32>) -> vec3<f32>
{
    var u_6 : f32 = precise_random_0(key_5, dimension_4);
    var rest_5 : f32 = u_6 * 20.0f - 1.0f;
    var _S111 : u32 = map_4 + u32(13);
    var is_black_1 : bool = (word_0(_S111)) == u32(4294967295);
    var _S112 : bool;
    if(is_black_1)
    {
        _S112 = true;
    }
    else
    {
        _S112 = rest_5 < 0.0f;
    }
    if(_S112)
    {
        var share_0 : f32;
        if(is_black_1)
        {
            share_0 = 1.0f;
        }
        else
        {
            share_0 = 0.05000000074505806f;
        }
        var direction_8 : vec3<f32> = uniform_direction_0(vec2<f32>(u_6 / share_0, random_0(key_5, dimension_4 + u32(1))));
        var _S113 : f32 = map_pdf_0(map_4, direction_8);
        (*pdf_1) = _S113;
        return direction_8;
    }
    var rest_6 : f32 = rest_5 / 19.0f;
    var width_2 : u32 = word_0(map_4);
    var down_1 : f32;
    var row_3 : u32 = chosen_interval_0(word_0(_S111), word_0(map_4 + u32(1)) - u32(1), precise_random_0(key_5, dimension_4 + u32(1)), &(down_1));
    var along_2 : f32;
    var column_2 : u32 = chosen_interval_0(word_0(map_4 + u32(14)) + u32(2) * width_2 * row_3, width_2, rest_6, &(along_2));
    (*pdf_1) = cell_pdf_0(map_4, row_3 * width_2 + column_2);
    return cell_direction_0(map_4, column_2, row_3, along_2, down_1);
}

fn random_pair_0( key_6 : vec2<u32>,  dimension_5 : u32) -> vec2<f32>
{
    return vec2<f32>(random_0(key_6, dimension_5), random_0(key_6, dimension_5 + u32(1)));
}

fn sample_cosine_0( u_7 : vec2<f32>) -> vec3<f32>
{
    var _S114 : f32 = u_7.x;
    var turn_2 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_7.y) * vec2<f32>(sqrt(_S114));
    return vec3<f32>(turn_2.y, turn_2.x, sqrt(1.0f - _S114));
}

fn to_world_0( axes_5 : Axes_0,  v_7 : vec3<f32>) -> vec3<f32>
{
    return axes_5.s_0 * vec3<f32>(v_7.x) + axes_5.t_0 * vec3<f32>(v_7.y) + axes_5.n_1 * vec3<f32>(v_7.z);
}

struct LightSample_0
{
     direction_9 : vec3<f32>,
     wo_0 : vec3<f32>,
     way_1 : vec3<f32>,
     nearest_0 : f32,
     farthest_0 : f32,
     is_on_emitter_0 : bool,
     emitter_5 : u32,
     probability_1 : f32,
     pdf_2 : f32,
     distance_4 : f32,
     place_13 : Place_0,
     is_specular_0 : bool,
};

fn sample_emitter_0( vertex_1 : Vertex_0,  choice_5 : Choice_0,  key_7 : vec2<u32>,  first_3 : u32,  sample_0 : ptr<function, LightSample_0>) -> bool
{
    (*sample_0).is_on_emitter_0 = true;
    (*sample_0).is_specular_0 = false;
    (*sample_0).direction_9 = vertex_1.axes_4.n_1;
    (*sample_0).wo_0 = vec3<f32>(0.0f);
    (*sample_0).way_1 = vertex_1.surface_3.exact_0;
    (*sample_0).distance_4 = 0.0f;
    (*sample_0).pdf_2 = 0.0f;
    (*sample_0).place_13 = vertex_1.surface_3.place_3;
    (*sample_0).nearest_0 = limit_at_0(u32(2));
    (*sample_0).farthest_0 = limit_at_0(u32(1));
    var _S115 : f32 = random_0(key_7, first_3);
    var _S116 : f32 = (*sample_0).probability_1;
    var _S117 : u32 = chosen_emitter_0(choice_5, _S115, &(_S116));
    (*sample_0).probability_1 = _S116;
    (*sample_0).emitter_5 = _S117;
    if(_S116 == 0.0f)
    {
        return false;
    }
    var record_12 : u32 = emitter_record_0((*sample_0).emitter_5);
    if(is_area_0(record_12))
    {
        var point_1 : EmitterPoint_0 = area_point_0(record_12, vertex_1.surface_3, key_7, first_3 + u32(1));
        if(!((point_1.pdf_0) > 0.0f))
        {
            return false;
        }
        (*sample_0).pdf_2 = point_1.pdf_0;
        (*sample_0).place_13 = point_1.place_11;
        var _S118 : vec3<f32> = position_of_0(point_1.place_11) - vertex_1.surface_3.exact_0;
        (*sample_0).way_1 = _S118;
        var _S119 : f32 = length(_S118);
        (*sample_0).distance_4 = _S119;
        (*sample_0).direction_9 = _S118 / vec3<f32>(_S119);
        (*sample_0).nearest_0 = (*sample_0).nearest_0 / _S119;
        (*sample_0).farthest_0 = limit_at_0(u32(3));
    }
    else
    {
        if(is_map_0(record_12))
        {
            var _S120 : u32 = word_0(record_12 + u32(1));
            var _S121 : u32 = first_3 + u32(1);
            var _S122 : f32 = (*sample_0).pdf_2;
            var _S123 : vec3<f32> = sample_map_0(_S120, key_7, _S121, &(_S122));
            (*sample_0).pdf_2 = _S122;
            (*sample_0).direction_9 = _S123;
        }
        else
        {
            var local_1 : vec3<f32> = sample_cosine_0(random_pair_0(key_7, first_3 + u32(1)));
            (*sample_0).direction_9 = normalize(to_world_0(vertex_1.axes_4, local_1));
            (*sample_0).pdf_2 = local_1.z * 0.31830987334251404f;
        }
        (*sample_0).way_1 = (*sample_0).direction_9;
    }
    var _S124 : vec3<f32> = to_local_0(vertex_1.axes_4, (*sample_0).direction_9);
    (*sample_0).wo_0 = _S124;
    return (_S124.z) > 0.0f;
}

fn first_material_number_0( depth_2 : u32) -> u32
{
    return vertex_numbers_0(depth_2) + u32(3) * word_0(u32(2));
}

fn coat_eta_0( numbers_3 : Numbers_0) -> f32
{
    return luminance_0(numbers_3.eta_0) / luminance_0(numbers_3.k_0);
}

fn fresnel_dielectric_0( cosine_4 : f32,  eta_1 : f32) -> f32
{
    var eta2_0 : f32 = eta_1 * eta_1;
    var cos2_0 : f32 = cosine_4 * cosine_4;
    var denser_0 : f32 = (eta_1 - 1.0f) * (eta_1 + 1.0f);
    var squared_3 : f32 = denser_0 + cos2_0;
    if(squared_3 <= 0.0f)
    {
        return 1.0f;
    }
    var refracted_0 : f32 = sqrt(squared_3);
    var s_sum_0 : f32 = cosine_4 + refracted_0;
    var p_sum_0 : f32 = eta2_0 * cosine_4 + refracted_0;
    var senkrecht_0 : f32 = denser_0 / (s_sum_0 * s_sum_0);
    var parallel_0 : f32 = denser_0 * ((eta2_0 + 1.0f) * cos2_0 - 1.0f) / (p_sum_0 * p_sum_0);
    return 0.5f * (senkrecht_0 * senkrecht_0 + parallel_0 * parallel_0);
}

fn transmittance_0( lobe_3 : Lobe_0,  eta_2 : f32,  cosine_5 : f32) -> f32
{
    if((lobe_3.kind_1) == u32(3))
    {
        return 1.0f - fresnel_dielectric_0(cosine_5, eta_2);
    }
    var place_14 : f32 = cosine_5 * 63.0f;
    var _S125 : u32 = min(u32(place_14), u32(62));
    var at_15 : u32 = word_0(lobe_3.record_2 + u32(3)) + _S125;
    var here_0 : f32 = number_0(at_15);
    return here_0 + (number_0(at_15 + u32(1)) - here_0) * (place_14 - f32(_S125));
}

fn choice_weight_0( colour_2 : vec3<f32>) -> f32
{
    return max((colour_2.x + colour_2.y + colour_2.z) / 3.0f, 0.05000000074505806f);
}

fn base_probability_0( numbers_4 : Numbers_0,  enters_0 : f32) -> f32
{
    var of_base_0 : f32 = enters_0 * choice_weight_0(numbers_4.diffuse_reflectance_0);
    return of_base_0 / (of_base_0 + (1.0f - enters_0) * choice_weight_0(numbers_4.specular_reflectance_0));
}

fn is_rough_0( lobe_4 : Lobe_0) -> bool
{
    var _S126 : bool;
    if((lobe_4.kind_1) == u32(2))
    {
        _S126 = true;
    }
    else
    {
        _S126 = (lobe_4.kind_1) == u32(4);
    }
    return _S126;
}

struct Microfacets_0
{
     distribution_1 : u32,
     alpha_1 : vec2<f32>,
};

fn facets_of_0( lobe_5 : Lobe_0,  numbers_5 : Numbers_0) -> Microfacets_0
{
    var facets_0 : Microfacets_0;
    facets_0.distribution_1 = lobe_5.distribution_0;
    facets_0.alpha_1 = max(numbers_5.alpha_0, vec2<f32>(0.00009999999747379f));
    return facets_0;
}

struct Stretched_0
{
     sine_4 : f32,
     cosine_6 : f32,
     around_0 : vec2<f32>,
     length_0 : f32,
};

fn stretched_0( facets_1 : Microfacets_0,  wi_2 : vec3<f32>) -> Stretched_0
{
    var longer_0 : vec3<f32> = vec3<f32>(wi_2.xy * facets_1.alpha_1, wi_2.z);
    var view_2 : Stretched_0;
    var _S127 : f32 = length(longer_0);
    view_2.length_0 = _S127;
    var longer_1 : vec3<f32> = longer_0 / vec3<f32>(_S127);
    var _S128 : vec2<f32> = longer_1.xy;
    var _S129 : f32 = length(_S128);
    view_2.sine_4 = _S129;
    view_2.cosine_6 = longer_1.z;
    var _S130 : vec2<f32>;
    if(_S129 > 0.0f)
    {
        _S130 = _S128 / vec2<f32>(view_2.sine_4);
    }
    else
    {
        _S130 = vec2<f32>(1.0f, 0.0f);
    }
    view_2.around_0 = _S130;
    return view_2;
}

fn ggx_normal_0( view_3 : Stretched_0,  u_8 : vec2<f32>) -> vec3<f32>
{
    var _S131 : f32 = u_8.x;
    var radius_2 : f32 = sqrt(_S131);
    var turn_3 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_8.y);
    var across_1 : f32 = radius_2 * turn_3.y;
    var along_3 : f32 = radius_2 * turn_3.x;
    var visible_0 : f32 = 0.5f * (1.0f + view_3.cosine_6);
    var hidden_0 : f32 = 1.0f - visible_0;
    var _S132 : f32 = 1.0f - _S131;
    var edge_0 : f32 = sqrt(_S132 + along_3 * along_3);
    var up_0 : f32 = hidden_0 * edge_0 + visible_0 * along_3;
    var from_top_0 : f32 = edge_0 - along_3;
    var from_bottom_0 : f32 = edge_0 + along_3;
    var from_top_1 : f32;
    var from_bottom_1 : f32;
    if(along_3 > 0.0f)
    {
        from_top_1 = _S132 / from_bottom_0;
        from_bottom_1 = from_bottom_0;
    }
    else
    {
        var _S133 : f32 = _S132 / from_top_0;
        from_top_1 = from_top_0;
        from_bottom_1 = _S133;
    }
    var towards_0 : f32 = sqrt(visible_0 * from_top_1 * (2.0f * hidden_0 * edge_0 + visible_0 * from_bottom_1));
    return vec3<f32>(towards_0 * view_3.sine_4 - up_0 * view_3.cosine_6, across_1, max(towards_0 * view_3.cosine_6 + up_0 * view_3.sine_4, 0.0f));
}

fn exponential_0( x_8 : f32) -> f32
{
    if(x_8 < -87.0f)
    {
        return 0.0f;
    }
    var power_0 : f32 = floor(x_8 * 1.4426950216293335f + 0.5f);
    var r_0 : f32 = x_8 - power_0 * 0.693359375f + power_0 * 0.00021219444170129f;
    return ((((((0.00019875691214111f * r_0 + 0.00139819993637502f) * r_0 + 0.00833345204591751f) * r_0 + 0.04166579619050026f) * r_0 + 0.1666666567325592f) * r_0 + 0.5f) * r_0 * r_0 + r_0 + 1.0f) * (bitcast<f32>(((u32(i32(power_0) + i32(127)) << (u32(23))))));
}

fn error_function_plus_one_0( x_9 : f32) -> vec2<f32>
{
    var _S134 : f32 = min(abs(x_9), 6.0f);
    var gaussian_0 : f32 = exponential_0(- _S134 * _S134);
    var place_15 : f32 = (_S134 - 2.0f) / (_S134 + 2.0f);
    var complement_0 : f32 = gaussian_0 * (((((((((-0.00042725281673484f * place_15 - 0.00127731403335929f) * place_15 + 0.00131371302995831f) * place_15 + 0.008666617795825f) * place_15 - 0.00805134233087301f) * place_15 - 0.05421232059597969f) * place_15 + 0.1640533059835434f) * place_15 - 0.16603080928325653f) * place_15 - 0.09276388585567474f) * place_15 + 1.27697837352752686f) / (1.0f + 2.0f * _S134);
    var _S135 : f32;
    if(x_9 < 0.0f)
    {
        _S135 = complement_0;
    }
    else
    {
        _S135 = 2.0f - complement_0;
    }
    return vec2<f32>(_S135, 1.128379225730896f * gaussian_0);
}

fn visible_over_cos_0( facets_2 : Microfacets_0,  w_4 : vec3<f32>) -> f32
{
    var stretched_1 : vec2<f32> = w_4.xy * facets_2.alpha_1;
    var spread2_0 : f32 = dot(stretched_1, stretched_1);
    var _S136 : f32 = w_4.z;
    var z2_1 : f32 = _S136 * _S136;
    if((facets_2.distribution_1) == u32(1))
    {
        return 2.0f / (_S136 + sqrt(z2_1 + spread2_0));
    }
    if(z2_1 >= (36.0f * spread2_0))
    {
        return 1.0f / _S136;
    }
    var spread_0 : f32 = sqrt(spread2_0);
    var both_0 : vec2<f32> = error_function_plus_one_0(_S136 / spread_0);
    return 2.0f / (_S136 * both_0.x + 0.5f * spread_0 * both_0.y);
}

fn logarithm_0( x_10 : f32) -> f32
{
    var bits_0 : u32 = (bitcast<u32>((x_10)));
    var power_1 : f32 = f32(i32((bits_0 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((bits_0 & (u32(8388607)))) | (u32(1056964608))))));
    var m_1 : f32;
    var power_2 : f32;
    if(m_0 < 0.70710676908493042f)
    {
        var power_3 : f32 = power_1 - 1.0f;
        m_1 = m_0 + m_0;
        power_2 = power_3;
    }
    else
    {
        m_1 = m_0;
        power_2 = power_1;
    }
    var m_2 : f32 = m_1 - 1.0f;
    var z_3 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * z_3 - 0.00021219444170129f * power_2 - 0.5f * z_3) + 0.693359375f * power_2;
}

fn error_function_inverse_0( p_0 : f32) -> f32
{
    var w_5 : f32 = - logarithm_0((1.0f - p_0) * (1.0f + p_0));
    if(w_5 < 5.0f)
    {
        var w_6 : f32 = w_5 - 2.5f;
        return ((((((((2.81022636272609816e-08f * w_6 + 3.43273939051869093e-07f) * w_6 - 3.52338770426285919e-06f) * w_6 - 4.39150653619435616e-06f) * w_6 + 0.00021858086984139f) * w_6 - 0.00125372502952814f) * w_6 - 0.00417768163606524f) * w_6 + 0.24664072692394257f) * w_6 + 1.50140941143035889f) * p_0;
    }
    var w_7 : f32 = sqrt(w_5) - 3.0f;
    return ((((((((-0.0002002142573474f * w_7 + 0.00010095055768033f) * w_7 + 0.00134934321977198f) * w_7 - 0.00367342843674123f) * w_7 + 0.00573950773105025f) * w_7 - 0.00762246130034328f) * w_7 + 0.00943887047469616f) * w_7 + 1.00167405605316162f) * w_7 + 2.8329768180847168f) * p_0;
}

fn beckmann_normal_0( view_4 : Stretched_0,  visible_1 : f32,  u_9 : vec2<f32>) -> vec3<f32>
{
    var steepest_0 : f32;
    if((view_4.sine_4 * 6.0f) > (view_4.cosine_6))
    {
        steepest_0 = view_4.cosine_6 / view_4.sine_4;
    }
    else
    {
        steepest_0 = 6.0f;
    }
    var target_1 : f32 = u_9.x * (2.0f / (visible_1 * view_4.length_0));
    var _S137 : f32 = max(view_4.cosine_6, view_4.sine_4);
    var slope_0 : f32 = clamp(error_function_inverse_0(clamp(target_1 / _S137 - 1.0f, -0.99999994039535522f, 0.99999994039535522f)) + -0.5f * view_4.sine_4 / _S137, -6.0f, 0.5f * steepest_0);
    var low_4 : f32 = -6.0f;
    var high_1 : f32 = steepest_0;
    var step_0 : u32 = u32(0);
    for(;;)
    {
        if(step_0 < u32(32))
        {
        }
        else
        {
            break;
        }
        var both_1 : vec2<f32> = error_function_plus_one_0(slope_0);
        var _S138 : f32 = both_1.y;
        var error_0 : f32 = view_4.cosine_6 * both_1.x + 0.5f * view_4.sine_4 * _S138 - target_1;
        var own_2 : f32 = _S138 * (view_4.cosine_6 - slope_0 * view_4.sine_4);
        var bend_0 : f32 = -2.0f * slope_0 * own_2 - _S138 * view_4.sine_4;
        if(error_0 > 0.0f)
        {
            high_1 = slope_0;
        }
        else
        {
            low_4 = slope_0;
        }
        var next_0 : f32 = slope_0 - error_0 * own_2 / (own_2 * own_2 - 0.5f * error_0 * bend_0);
        var _S139 : bool;
        if(next_0 >= low_4)
        {
            _S139 = next_0 <= high_1;
        }
        else
        {
            _S139 = false;
        }
        var next_1 : f32;
        if(!_S139)
        {
            next_1 = 0.5f * (low_4 + high_1);
        }
        else
        {
            next_1 = next_0;
        }
        if((abs(next_1 - slope_0)) < 0.00030000001424924f)
        {
            slope_0 = next_1;
            break;
        }
        var _S140 : u32 = step_0 + u32(1);
        slope_0 = next_1;
        step_0 = _S140;
    }
    return vec3<f32>(- slope_0, error_function_inverse_0(max(2.0f * u_9.y - 1.0f, -0.99999994039535522f)), 1.0f);
}

fn mirrored_at_facet_0( facets_3 : Microfacets_0,  wi_3 : vec3<f32>,  u_10 : vec2<f32>) -> vec3<f32>
{
    var view_5 : Stretched_0 = stretched_0(facets_3, wi_3);
    var normal_7 : vec3<f32>;
    if((facets_3.distribution_1) == u32(1))
    {
        normal_7 = ggx_normal_0(view_5, u_10);
    }
    else
    {
        normal_7 = beckmann_normal_0(view_5, visible_over_cos_0(facets_3, wi_3), u_10);
    }
    var _S141 : f32 = view_5.around_0.x;
    var _S142 : f32 = normal_7.x;
    var _S143 : f32 = view_5.around_0.y;
    var _S144 : f32 = normal_7.y;
    var normal_8 : vec3<f32> = normalize(vec3<f32>(vec2<f32>(_S141 * _S142 - _S143 * _S144, _S143 * _S142 + _S141 * _S144) * facets_3.alpha_1, normal_7.z));
    return normalize(normal_8 * vec3<f32>((2.0f * dot(wi_3, normal_8))) - wi_3);
}

struct Drawn_0
{
     wo_1 : vec3<f32>,
     is_specular_1 : bool,
     probability_2 : f32,
};

fn draw_0( lobe_6 : Lobe_0,  wi_4 : vec3<f32>,  choice_6 : f32,  u_11 : vec2<f32>) -> Drawn_0
{
    var _S145 : bool = (lobe_6.kind_1) == u32(0);
    var has_base_0 : bool;
    if(_S145)
    {
        has_base_0 = true;
    }
    else
    {
        has_base_0 = (lobe_6.kind_1) == u32(3);
    }
    if(has_base_0)
    {
        has_base_0 = true;
    }
    else
    {
        has_base_0 = (lobe_6.kind_1) == u32(4);
    }
    var of_base_1 : f32;
    if(_S145)
    {
        of_base_1 = 1.0f;
    }
    else
    {
        of_base_1 = 0.0f;
    }
    var _S146 : bool;
    if((lobe_6.kind_1) == u32(3))
    {
        _S146 = true;
    }
    else
    {
        _S146 = (lobe_6.kind_1) == u32(4);
    }
    if(_S146)
    {
        of_base_1 = base_probability_0(lobe_6.numbers_2, transmittance_0(lobe_6, coat_eta_0(lobe_6.numbers_2), wi_4.z));
    }
    var drawn_0 : Drawn_0;
    drawn_0.is_specular_1 = false;
    drawn_0.probability_2 = 1.0f;
    if(has_base_0)
    {
        has_base_0 = choice_6 < of_base_1;
    }
    else
    {
        has_base_0 = false;
    }
    if(has_base_0)
    {
        drawn_0.wo_1 = sample_cosine_0(u_11);
    }
    else
    {
        if(is_rough_0(lobe_6))
        {
            drawn_0.wo_1 = mirrored_at_facet_0(facets_of_0(lobe_6, lobe_6.numbers_2), wi_4, u_11);
        }
        else
        {
            drawn_0.wo_1 = vec3<f32>((vec2<f32>(0) - wi_4.xy), wi_4.z);
            drawn_0.is_specular_1 = true;
            drawn_0.probability_2 = 1.0f - of_base_1;
        }
    }
    return drawn_0;
}

fn sample_material_0( vertex_2 : Vertex_0,  key_8 : vec2<u32>,  first_4 : u32) -> LightSample_0
{
    var drawn_1 : Drawn_0 = draw_0(vertex_2.lobe_1, value_of_0(vertex_2.wi_1), random_0(key_8, first_4), random_pair_0(key_8, first_4 + u32(1)));
    var sample_1 : LightSample_0;
    sample_1.is_on_emitter_0 = false;
    sample_1.is_specular_0 = drawn_1.is_specular_1;
    sample_1.probability_1 = drawn_1.probability_2;
    sample_1.wo_0 = drawn_1.wo_1;
    var _S147 : vec3<f32> = normalize(to_world_0(vertex_2.axes_4, drawn_1.wo_1));
    sample_1.direction_9 = _S147;
    sample_1.way_1 = _S147;
    sample_1.nearest_0 = limit_at_0(u32(2));
    sample_1.farthest_0 = limit_at_0(u32(1));
    sample_1.emitter_5 = u32(4294967295);
    sample_1.distance_4 = 0.0f;
    sample_1.pdf_2 = 0.0f;
    sample_1.place_13 = vertex_2.surface_3.place_3;
    return sample_1;
}

fn exact_unit_0( v_8 : vec3<f32>) -> vec3<f32>
{
    return v_8 / vec3<f32>(sqrt(dot(v_8, v_8)));
}

struct Mirror_0
{
     corner_0 : vec3<f32>,
     ab_2 : vec3<f32>,
     ac_1 : vec3<f32>,
     normal_9 : vec3<f32>,
};

fn mirror_at_0( triangle_7 : u32) -> Mirror_0
{
    var at_16 : u32 = u32(9) * triangle_7;
    var mirror_0 : Mirror_0;
    var _S148 : vec3<f32> = primitive_vector_0(at_16);
    mirror_0.corner_0 = _S148;
    var _S149 : vec3<f32> = primitive_vector_0(at_16 + u32(3)) - _S148;
    mirror_0.ab_2 = _S149;
    var _S150 : vec3<f32> = primitive_vector_0(at_16 + u32(6)) - _S148;
    mirror_0.ac_1 = _S150;
    mirror_0.normal_9 = exact_unit_0(cross(_S149, _S150));
    return mirror_0;
}

fn mirrored_0( mirror_1 : Mirror_0,  direction_10 : vec3<f32>) -> vec3<f32>
{
    return direction_10 - mirror_1.normal_9 * vec3<f32>((2.0f * dot(mirror_1.normal_9, direction_10)));
}

fn walked_of_0( path_6 : Path_0) -> vec3<f32>
{
    return vec3<f32>(0.0f);
}

fn specular_direction_0( vertex_3 : Vertex_0,  direction_11 : vec3<f32>,  wo_2 : vec3<f32>) -> vec3<f32>
{
    return direction_11;
}

fn fresnel_conductor_channel_0( cosine_7 : f32,  eta_3 : f32,  k_3 : f32) -> f32
{
    var cos2_1 : f32 = cosine_7 * cosine_7;
    var sin2_0 : f32 = 1.0f - cos2_1;
    var real_0 : f32 = eta_3 * eta_3 - k_3 * k_3 - sin2_0;
    var product_1 : f32 = eta_3 * k_3;
    var modulus_0 : f32 = sqrt(real_0 * real_0 + 4.0f * (product_1 * product_1));
    if(modulus_0 == 0.0f)
    {
        return 1.0f;
    }
    var larger_0 : f32 = sqrt(0.5f * (modulus_0 + abs(real_0)));
    var smaller_0 : f32 = product_1 / larger_0;
    var _S151 : bool = real_0 < 0.0f;
    var a_14 : f32;
    if(_S151)
    {
        a_14 = smaller_0;
    }
    else
    {
        a_14 = larger_0;
    }
    var b_12 : f32;
    if(_S151)
    {
        b_12 = larger_0;
    }
    else
    {
        b_12 = smaller_0;
    }
    var less_0 : f32 = a_14 - cosine_7;
    var more_0 : f32 = a_14 + cosine_7;
    var _S152 : f32 = b_12 * b_12;
    var p_sum_1 : f32 = modulus_0 * cos2_1 + sin2_0 * sin2_0;
    return (less_0 * less_0 + _S152) / (more_0 * more_0 + _S152) * p_sum_1 / (p_sum_1 + 2.0f * a_14 * cosine_7 * sin2_0);
}

fn fresnel_conductor_0( cosine_8 : f32,  eta_4 : vec3<f32>,  k_4 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(fresnel_conductor_channel_0(cosine_8, eta_4.x, k_4.x), fresnel_conductor_channel_0(cosine_8, eta_4.y, k_4.y), fresnel_conductor_channel_0(cosine_8, eta_4.z, k_4.z));
}

fn specular_fraction_0( lobe_7 : Lobe_0,  numbers_6 : Numbers_0,  wi_5 : vec3<f32>) -> vec3<f32>
{
    if((lobe_7.kind_1) == u32(1))
    {
        return numbers_6.specular_reflectance_0 * fresnel_conductor_0(wi_5.z, numbers_6.eta_0, numbers_6.k_0);
    }
    return numbers_6.specular_reflectance_0 * vec3<f32>(fresnel_dielectric_0(wi_5.z, coat_eta_0(numbers_6)));
}

fn specular_0( lobe_8 : Lobe_0,  wi_6 : vec3<f32>) -> vec3<f32>
{
    return specular_fraction_0(lobe_8, lobe_8.numbers_2, wi_6);
}

fn turning_0( vertex_4 : Vertex_0,  direction_12 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(0.0f);
}

fn towards_emitter_0( vertex_5 : Vertex_0,  direction_13 : vec3<f32>,  record_13 : u32) -> vec3<f32>
{
    var _S153 : vec3<f32>;
    if((word_0(record_13)) == u32(1))
    {
        _S153 = changing_0(direction_13, turning_0(vertex_5, direction_13));
    }
    else
    {
        _S153 = still_0(direction_13);
    }
    return _S153;
}

fn turns_onward_0() -> bool
{
    return true;
}

fn local_change_0( vertex_6 : Vertex_0,  direction_14 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(0.0f);
}

struct Mirrored_0
{
     cosine_9 : f32,
     pdf_3 : f32,
     scattered_0 : f32,
};

fn Mirrored_x24init_0( cosine_10 : f32,  pdf_4 : f32,  scattered_1 : f32) -> Mirrored_0
{
    var _S154 : Mirrored_0;
    _S154.cosine_9 = cosine_10;
    _S154.pdf_3 = pdf_4;
    _S154.scattered_0 = scattered_1;
    return _S154;
}

fn density_0( facets_4 : Microfacets_0,  m_3 : vec3<f32>) -> f32
{
    var _S155 : f32 = m_3.z;
    if(_S155 <= 0.0f)
    {
        return 0.0f;
    }
    var scale_0 : f32 = 3.14159274101257324f * facets_4.alpha_1.x * facets_4.alpha_1.y;
    var slope_1 : vec2<f32> = m_3.xy / facets_4.alpha_1;
    var spread_1 : f32 = dot(slope_1, slope_1);
    var cos2_2 : f32 = _S155 * _S155;
    if((facets_4.distribution_1) == u32(1))
    {
        var sum_2 : f32 = spread_1 + cos2_2;
        return 1.0f / (scale_0 * sum_2 * sum_2);
    }
    var exponent_0 : f32 = spread_1 / cos2_2;
    var _S156 : f32;
    if(exponent_0 > 80.0f)
    {
        _S156 = 0.0f;
    }
    else
    {
        _S156 = exponential_0(- exponent_0) / (scale_0 * cos2_2 * cos2_2);
    }
    return _S156;
}

fn mirrored_1( facets_5 : Microfacets_0,  wi_7 : vec3<f32>,  wo_3 : vec3<f32>) -> Mirrored_0
{
    var h_1 : vec3<f32> = normalize(wi_7 + wo_3);
    var mirrored_2 : Mirrored_0;
    mirrored_2.cosine_9 = dot(wi_7, h_1);
    var _S157 : f32 = 0.25f * density_0(facets_5, h_1) * visible_over_cos_0(facets_5, wi_7);
    mirrored_2.pdf_3 = _S157;
    mirrored_2.scattered_0 = _S157 * visible_over_cos_0(facets_5, wo_3) * wo_3.z;
    return mirrored_2;
}

fn fresnel_diffuse_0( eta_5 : f32) -> f32
{
    var inverse_0 : f32 = 1.0f / eta_5;
    if(eta_5 < 1.0f)
    {
        return (-1.43990004062652588f * eta_5 + 0.70990002155303955f) * eta_5 + 0.66809999942779541f + 0.06360000371932983f * inverse_0;
    }
    return ((((-1.36881005764007568f * inverse_0 + 4.98553991317749023f) * inverse_0 - 7.80988979339599609f) * inverse_0 + 6.75334978103637695f) * inverse_0 - 3.47930002212524414f) * inverse_0 + 0.91931700706481934f;
}

fn base_0( lobe_9 : Lobe_0,  eta_6 : f32,  diffuse_0 : vec3<f32>) -> vec3<f32>
{
    var internal_reflectance_0 : f32;
    if((lobe_9.kind_1) == u32(3))
    {
        internal_reflectance_0 = fresnel_diffuse_0(1.0f / eta_6);
    }
    else
    {
        internal_reflectance_0 = number_0(word_0(lobe_9.record_2 + u32(3)) + u32(64));
    }
    if((word_0(lobe_9.record_2 + u32(2))) == u32(0))
    {
        return diffuse_0 * vec3<f32>((1.0f / (1.0f - internal_reflectance_0)));
    }
    return diffuse_0 / (vec3<f32>(1.0f) - diffuse_0 * vec3<f32>(internal_reflectance_0));
}

struct Scattering_0
{
     value_7 : vec3<f32>,
     pdf_5 : f32,
};

fn scattering_0( lobe_10 : Lobe_0,  numbers_7 : Numbers_0,  wi_8 : vec3<f32>,  wo_4 : vec3<f32>) -> Scattering_0
{
    var scattering_1 : Scattering_0;
    var _S158 : f32 = wo_4.z;
    var by_cosine_0 : f32 = _S158 * 0.31830987334251404f;
    if((lobe_10.kind_1) == u32(0))
    {
        scattering_1.value_7 = numbers_7.diffuse_reflectance_0 * vec3<f32>(by_cosine_0);
        scattering_1.pdf_5 = by_cosine_0;
        return scattering_1;
    }
    var _S159 : Mirrored_0 = Mirrored_x24init_0(0.0f, 0.0f, 0.0f);
    var by_facets_0 : Mirrored_0;
    if(is_rough_0(lobe_10))
    {
        by_facets_0 = mirrored_1(facets_of_0(lobe_10, numbers_7), wi_8, wo_4);
    }
    else
    {
        by_facets_0 = _S159;
    }
    if((lobe_10.kind_1) == u32(2))
    {
        scattering_1.value_7 = numbers_7.specular_reflectance_0 * (fresnel_conductor_0(by_facets_0.cosine_9, numbers_7.eta_0, numbers_7.k_0) * vec3<f32>(by_facets_0.scattered_0));
        scattering_1.pdf_5 = by_facets_0.pdf_3;
        return scattering_1;
    }
    var eta_7 : f32 = coat_eta_0(numbers_7);
    var enters_1 : f32 = transmittance_0(lobe_10, eta_7, wi_8.z);
    scattering_1.value_7 = base_0(lobe_10, eta_7, numbers_7.diffuse_reflectance_0) * vec3<f32>((enters_1 * transmittance_0(lobe_10, eta_7, _S158) * by_cosine_0 / (eta_7 * eta_7)));
    var probability_3 : f32 = base_probability_0(numbers_7, enters_1);
    scattering_1.pdf_5 = probability_3 * by_cosine_0;
    if((lobe_10.kind_1) == u32(4))
    {
        scattering_1.value_7 = scattering_1.value_7 + numbers_7.specular_reflectance_0 * vec3<f32>((fresnel_dielectric_0(by_facets_0.cosine_9, eta_7) * by_facets_0.scattered_0));
        scattering_1.pdf_5 = scattering_1.pdf_5 + (1.0f - probability_3) * by_facets_0.pdf_3;
    }
    return scattering_1;
}

struct Scattered_0
{
     value_8 : vec3<f32>,
     pdf_6 : f32,
};

fn eval_and_pdf_0( lobe_11 : Lobe_0,  wi_9 : vec3<f32>,  wo_5 : vec3<f32>) -> Scattered_0
{
    var scattered_2 : Scattered_0;
    scattered_2.value_8 = still_0(vec3<f32>(0.0f));
    scattered_2.pdf_6 = 0.0f;
    var _S160 : bool;
    if((value_of_0(wo_5).z) <= 0.0f)
    {
        _S160 = true;
    }
    else
    {
        _S160 = !has_smooth_0(lobe_11);
    }
    if(_S160)
    {
        return scattered_2;
    }
    var both_2 : Scattering_0 = scattering_0(lobe_11, lobe_11.numbers_2, wi_9, wo_5);
    scattered_2.value_8 = both_2.value_7;
    scattered_2.pdf_6 = both_2.pdf_5;
    return scattered_2;
}

fn scattered_to_0( vertex_7 : Vertex_0,  wo_6 : vec3<f32>,  direction_15 : vec3<f32>) -> Scattered_0
{
    return eval_and_pdf_0(vertex_7.lobe_1, vertex_7.wi_1, changing_0(wo_6, local_change_0(vertex_7, direction_15)));
}

fn scattered_along_0( vertex_8 : Vertex_0,  sample_2 : LightSample_0,  walked_0 : vec3<f32>,  moving_0 : ptr<function, vec3<f32>>) -> Scattered_0
{
    if(sample_2.is_specular_0)
    {
        (*moving_0) = specular_direction_0(vertex_8, sample_2.direction_9, sample_2.wo_0);
        var scattered_3 : Scattered_0;
        scattered_3.value_8 = specular_0(vertex_8.lobe_1, vertex_8.wi_1);
        scattered_3.pdf_6 = sample_2.probability_1;
        return scattered_3;
    }
    if((sample_2.emitter_5) != u32(4294967295))
    {
        (*moving_0) = towards_emitter_0(vertex_8, sample_2.direction_9, emitter_record_0(sample_2.emitter_5));
    }
    else
    {
        var _S161 : vec3<f32>;
        if(turns_onward_0())
        {
            _S161 = turning_0(vertex_8, sample_2.direction_9);
        }
        else
        {
            _S161 = walked_0;
        }
        (*moving_0) = changing_0(sample_2.direction_9, _S161);
    }
    return scattered_to_0(vertex_8, sample_2.wo_0, (*moving_0));
}

fn component_0( v_9 : vec3<f32>,  axis_2 : u32) -> f32
{
    var _S162 : f32;
    if(axis_2 == u32(0))
    {
        _S162 = v_9.x;
    }
    else
    {
        if(axis_2 == u32(1))
        {
            _S162 = v_9.y;
        }
        else
        {
            _S162 = v_9.z;
        }
    }
    return _S162;
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
     largest_0 : f32,
};

fn ray_along_0( origin_1 : vec3<f32>,  direction_16 : vec3<f32>,  t_min_1 : f32,  t_max_1 : f32,  axes_6 : ptr<function, u32>) -> Ray_0
{
    var size_1 : vec3<f32> = abs(direction_16);
    var _S163 : f32 = size_1.x;
    var _S164 : f32 = size_1.y;
    var _S165 : bool;
    if(_S163 >= _S164)
    {
        _S165 = _S163 >= (size_1.z);
    }
    else
    {
        _S165 = false;
    }
    var _S166 : i32;
    if(_S165)
    {
        _S166 = i32(0);
    }
    else
    {
        if(_S164 >= (size_1.z))
        {
            _S166 = i32(1);
        }
        else
        {
            _S166 = i32(2);
        }
    }
    var z_4 : u32 = u32(_S166);
    var x_11 : u32 = (z_4 + u32(1)) % u32(3);
    var y_3 : u32 = (z_4 + u32(2)) % u32(3);
    (*axes_6) = (((x_11 | (((y_3 << (u32(2))))))) | (((z_4 << (u32(4))))));
    var ray_0 : Ray_0;
    ray_0.origin_0 = origin_1;
    var along_4 : f32 = component_0(direction_16, z_4);
    ray_0.inverse_z_0 = 1.0f / along_4;
    ray_0.shear_x_0 = component_0(direction_16, x_11) / along_4;
    ray_0.shear_y_0 = component_0(direction_16, y_3) / along_4;
    ray_0.t_min_0 = t_min_1;
    ray_0.t_max_0 = t_max_1;
    ray_0.local_per_t_0 = abs(along_4);
    ray_0.enter_0 = 0.0f;
    ray_0.edge_on_0 = limit_at_0(u32(0));
    ray_0.largest_0 = limit_at_0(u32(1));
    return ray_0;
}

fn ray_child_0( node_3 : u32,  slot_2 : u32) -> u32
{
    return nodes_0[u32(14) * node_3 + u32(12) + slot_2 / u32(4)][slot_2 % u32(4)];
}

struct RayView_0
{
     inverse_1 : vec3<f32>,
     offset_near_0 : vec3<f32>,
     offset_far_0 : vec3<f32>,
     limit_0 : f32,
     margin_0 : f32,
     axes_7 : u32,
};

fn ray_bound_0( view_6 : RayView_0,  limit_1 : f32,  node_4 : u32,  slot_3 : u32) -> f32
{
    var _S167 : u32 = u32(14) * node_4 + slot_3 / u32(4);
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
        var _S168 : u32 = axis_3;
        var _S169 : u32 = _S167 + u32(2) * axis_3;
        var _S170 : u32 = slot_3 % u32(4);
        var low_5 : f32 = (bitcast<f32>((nodes_0[_S169][_S170])));
        var high_2 : f32 = (bitcast<f32>((nodes_0[_S169 + u32(6)][_S170])));
        var _S171 : bool = (view_6.inverse_1[axis_3]) < 0.0f;
        var _S172 : f32;
        if(_S171)
        {
            _S172 = high_2;
        }
        else
        {
            _S172 = low_5;
        }
        var _S173 : f32 = max(near_0, _S172 * view_6.inverse_1[_S168] - view_6.offset_near_0[axis_3]);
        var _S174 : f32;
        if(_S171)
        {
            _S174 = low_5;
        }
        else
        {
            _S174 = high_2;
        }
        var _S175 : f32 = min(far_0, _S174 * view_6.inverse_1[_S168] - view_6.offset_far_0[axis_3]);
        var _S176 : u32 = axis_3 + u32(1);
        near_0 = _S173;
        far_0 = _S175;
        axis_3 = _S176;
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
        var _S177 : u32 = k_5;
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
            var _S178 : u32 = j_0;
            var _S179 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S177]))
            {
                _S179 = true;
            }
            else
            {
                if((bounds_0[_S178]) == (bounds_0[_S177]))
                {
                    _S179 = j_0 < k_5;
                }
                else
                {
                    _S179 = false;
                }
            }
            if(_S179)
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

fn crossed_0( view_7 : RayView_0,  limit_3 : f32,  node_5 : u32) -> u32
{
    var bounds_1 : array<f32, i32(8)>;
    var slot_4 : u32 = u32(0);
    for(;;)
    {
        if(slot_4 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S180 : f32;
        if((ray_child_0(node_5, slot_4)) == u32(4294967295))
        {
            _S180 = 3.00000000549775576e+38f;
        }
        else
        {
            _S180 = ray_bound_0(view_7, limit_3, node_5, slot_4);
        }
        bounds_1[slot_4] = _S180;
        slot_4 = slot_4 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn rounded_0( product_2 : f32,  largest_1 : f32) -> f32
{
    return min(product_2, largest_1);
}

fn corner_1( ray_1 : Ray_0,  axes_8 : u32,  at_17 : u32) -> vec3<f32>
{
    var relative_0 : vec3<f32> = primitive_vector_0(at_17) - ray_1.origin_0;
    var z_5 : f32 = component_0(relative_0, (axes_8 >> (u32(4))));
    return vec3<f32>(component_0(relative_0, (axes_8 & (u32(3)))) - rounded_0(ray_1.shear_x_0 * z_5, ray_1.largest_0), component_0(relative_0, (((axes_8 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_1.shear_y_0 * z_5, ray_1.largest_0), z_5);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_2 : f32,
     v_10 : f32,
     w_8 : f32,
};

fn intersect_0( ray_2 : Ray_0,  axes_9 : u32,  at_18 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_2 = 0.0f;
    crossing_0.v_10 = 0.0f;
    crossing_0.w_8 = 0.0f;
    var a_15 : vec3<f32> = corner_1(ray_2, axes_9, at_18);
    var b_13 : vec3<f32> = corner_1(ray_2, axes_9, at_18 + u32(3));
    var c_7 : vec3<f32> = corner_1(ray_2, axes_9, at_18 + u32(6));
    var _S181 : f32 = c_7.x;
    var _S182 : f32 = b_13.y;
    var cx_by_0 : f32 = rounded_0(_S181 * _S182, ray_2.largest_0);
    var _S183 : f32 = c_7.y;
    var _S184 : f32 = b_13.x;
    var cy_bx_0 : f32 = rounded_0(_S183 * _S184, ray_2.largest_0);
    var _S185 : f32 = a_15.x;
    var ax_cy_0 : f32 = rounded_0(_S185 * _S183, ray_2.largest_0);
    var _S186 : f32 = a_15.y;
    var ay_cx_0 : f32 = rounded_0(_S186 * _S181, ray_2.largest_0);
    var bx_ay_0 : f32 = rounded_0(_S184 * _S186, ray_2.largest_0);
    var by_ax_0 : f32 = rounded_0(_S182 * _S185, ray_2.largest_0);
    var u_12 : f32 = cx_by_0 - cy_bx_0;
    var v_11 : f32 = ax_cy_0 - ay_cx_0;
    var w_9 : f32 = bx_ay_0 - by_ax_0;
    var _S187 : f32 = min(min(u_12, v_11), w_9);
    var _S188 : f32 = max(max(u_12, v_11), w_9);
    var _S189 : bool;
    if(_S187 < 0.0f)
    {
        _S189 = _S188 > 0.0f;
    }
    else
    {
        _S189 = false;
    }
    if(_S189)
    {
        return crossing_0;
    }
    var determinant_0 : f32 = u_12 + v_11 + w_9;
    if(_S187 <= 0.0f)
    {
        _S189 = _S188 >= 0.0f;
    }
    else
    {
        _S189 = false;
    }
    if(_S189)
    {
        if((abs(determinant_0)) <= (ray_2.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0f)
    {
        return crossing_0;
    }
    var t_3 : f32 = (rounded_0(u_12 * a_15.z, ray_2.largest_0) + rounded_0(v_11 * b_13.z, ray_2.largest_0) + rounded_0(w_9 * c_7.z, ray_2.largest_0)) / determinant_0 * ray_2.inverse_z_0;
    if((ray_2.t_min_0) <= t_3)
    {
        _S189 = t_3 <= (ray_2.t_max_0);
    }
    else
    {
        _S189 = false;
    }
    crossing_0.is_hit_0 = _S189;
    crossing_0.t_2 = t_3;
    crossing_0.v_10 = v_11 / determinant_0;
    crossing_0.w_8 = w_9 / determinant_0;
    return crossing_0;
}

fn face_6( triangle_8 : u32) -> u32
{
    return rough_0[triangle_8 / u32(4)][triangle_8 % u32(4)];
}

struct Found_0
{
     face_7 : u32,
     triangle_9 : u32,
     v_12 : f32,
     w_10 : f32,
};

fn first_found_0( view_8 : RayView_0,  ray_3 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S190 : bool;
    var found_3 : Found_0;
    found_3.face_7 = u32(4294967295);
    found_3.triangle_9 = u32(4294967295);
    found_3.v_12 = 0.0f;
    found_3.w_10 = 0.0f;
    if(!((view_8.limit_0) >= 0.0f))
    {
        return found_3;
    }
    var way_2 : array<vec2<u32>, i32(40)>;
    way_2[i32(0)] = vec2<u32>(u32(0), u32(0));
    var entered_0 : u32 = u32(0);
    var limit_4 : f32 = view_8.limit_0;
    var is_new_0 : bool = true;
    var level_0 : u32 = u32(0);
    for(;;)
    {
        var entered_1 : u32;
        var is_new_1 : bool;
        if(entered_0 != u32(4294967295))
        {
            way_2[level_0] = vec2<u32>(entered_0, crossed_0(view_8, limit_4, entered_0));
            is_new_1 = true;
            entered_1 = u32(4294967295);
        }
        else
        {
            is_new_1 = is_new_0;
            entered_1 = entered_0;
        }
        var here_1 : vec2<u32> = way_2[level_0];
        var _S191 : u32 = way_2[level_0].y;
        if(_S191 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S192 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S192;
            continue;
        }
        var slot_5 : u32 = ((_S191 & (u32(15)))) - u32(1);
        way_2[level_0][i32(1)] = (_S191 >> (u32(4)));
        var _S193 : bool;
        if(!is_new_1)
        {
            _S193 = (ray_bound_0(view_8, limit_4, here_1.x, slot_5)) > limit_4;
        }
        else
        {
            _S193 = false;
        }
        if(_S193)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_1.x, slot_5);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S194 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S194;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S195 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S196 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_3 : u32 = _S196;
        for(;;)
        {
            if(i_3 < _S195)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_3), view_8.axes_7, u32(9) * i_3);
            if(!crossing_1.is_hit_0)
            {
                i_3 = i_3 + u32(1);
                continue;
            }
            if((found_3.face_7) == u32(4294967295))
            {
                _S190 = true;
            }
            else
            {
                _S190 = (crossing_1.t_2) < ((*ray_3).t_max_0);
            }
            var _S197 : bool;
            if(_S190)
            {
                _S197 = true;
            }
            else
            {
                _S197 = (face_6(i_3)) < (found_3.face_7);
            }
            var limit_6 : f32;
            if(_S197)
            {
                found_3.face_7 = face_6(i_3);
                found_3.triangle_9 = i_3;
                (*ray_3).t_max_0 = crossing_1.t_2;
                found_3.v_12 = crossing_1.v_10;
                found_3.w_10 = crossing_1.w_8;
                limit_6 = min(limit_5, crossing_1.t_2 * (*ray_3).local_per_t_0 - (*ray_3).enter_0 + 2.0f * view_8.margin_0);
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
            _S190 = (found_3.face_7) != u32(4294967295);
        }
        else
        {
            _S190 = false;
        }
        if(_S190)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_3;
}

fn cast_0( origin_2 : vec3<f32>,  direction_17 : vec3<f32>,  t_min_2 : f32,  t_max_2 : f32,  any_1 : bool,  t_4 : ptr<function, f32>) -> Found_0
{
    var view_9 : RayView_0;
    var _S198 : u32 = view_9.axes_7;
    var _S199 : Ray_0 = ray_along_0(origin_2, direction_17, t_min_2, t_max_2, &(_S198));
    view_9.axes_7 = _S198;
    var ray_4 : Ray_0 = _S199;
    var _S200 : vec3<f32> = direction_17 / vec3<f32>(ray_4.local_per_t_0);
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
        var _S201 : f32 = max(abs(_S200[axis_4]), 8.67361737988403547e-19f);
        var _S202 : f32;
        if((_S200[axis_4]) < 0.0f)
        {
            _S202 = -1.0f / _S201;
        }
        else
        {
            _S202 = 1.0f / _S201;
        }
        view_9.inverse_1[axis_4] = _S202;
        axis_4 = axis_4 + u32(1);
    }
    var offset_4 : vec3<f32> = origin_2 * view_9.inverse_1;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_9.inverse_1);
    view_9.offset_near_0 = offset_4 + wider_0;
    view_9.offset_far_0 = offset_4 - wider_0;
    view_9.limit_0 = min(t_max_2 * ray_4.local_per_t_0, 8.0f) + 3.814697265625e-06f;
    view_9.margin_0 = 3.814697265625e-06f;
    var found_4 : Found_0 = first_found_0(view_9, &(ray_4), any_1);
    (*t_4) = ray_4.t_max_0;
    return found_4;
}

fn place_of_0( found_5 : Found_0) -> Place_0
{
    return exact_place_0(found_5.triangle_9, found_5.v_12, found_5.w_10);
}

fn emitter_seen_0( found_6 : Found_0,  direction_18 : vec3<f32>) -> u32
{
    if((found_6.face_7) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_6 : u32 = word_0(shape_of_0(found_6.triangle_9) + u32(4));
    var _S203 : bool;
    if(emitter_6 != u32(4294967295))
    {
        _S203 = (dot(cross_of_0(found_6.triangle_9), direction_18)) < 0.0f;
    }
    else
    {
        _S203 = false;
    }
    var _S204 : u32;
    if(_S203)
    {
        _S204 = emitter_6;
    }
    else
    {
        _S204 = u32(4294967295);
    }
    return _S204;
}

fn area_pdf_0( record_14 : u32,  face_8 : u32,  from_2 : Surface_0,  direction_19 : vec3<f32>,  distance_5 : f32) -> f32
{
    var own_3 : f32;
    var rectangle_1 : u32 = word_0(record_14 + u32(4));
    if(rectangle_1 != u32(4294967295))
    {
        var _S205 : SeenRectangle_0 = seen_rectangle_0(rectangle_1, from_2.position_0);
        if(!((_S205.solid_angle_0) > 0.0f))
        {
            return 0.0f;
        }
        if((_S205.solid_angle_0) >= 0.00100000004749745f)
        {
            return 1.0f / _S205.solid_angle_0;
        }
    }
    var _S206 : u32 = word_0(word_0(record_14 + u32(7)) + face_8);
    var nodes_at_2 : u32 = word_0(record_14 + u32(5));
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
        var is_second_1 : bool = _S206 >= (word_0(nodes_at_2 + u32(17) * word_0(node_6 + u32(3))));
        if(is_second_1)
        {
            own_3 = shares_1.y;
        }
        else
        {
            own_3 = shares_1.x;
        }
        var chosen_3 : f32 = chosen_2 * own_3;
        var _S207 : i32;
        if(is_second_1)
        {
            _S207 = i32(3);
        }
        else
        {
            _S207 = i32(2);
        }
        node_6 = nodes_at_2 + u32(17) * word_0(node_6 + u32(_S207));
        chosen_2 = chosen_3;
    }
    var _S208 : u32 = word_0(record_14 + u32(6));
    var _S209 : u32 = word_0(node_6);
    own_3 = 0.0f;
    var k_6 : u32 = _S209;
    var total_3 : f32 = 0.0f;
    for(;;)
    {
        if(k_6 < (word_0(node_6 + u32(1))))
        {
        }
        else
        {
            break;
        }
        var angle_4 : f32 = face_solid_angle_0(record_14, word_0(_S208 + k_6), from_2.exact_0);
        var total_4 : f32 = total_3 + angle_4;
        if(k_6 == _S206)
        {
            own_3 = angle_4;
        }
        k_6 = k_6 + u32(1);
        total_3 = total_4;
    }
    if(!(own_3 > 0.0f))
    {
        return 0.0f;
    }
    return chosen_2 / total_3 * density_of_0(own_3, cross_of_0(emitter_triangle_0(record_14, face_8)), distance_5, direction_19);
}

fn emitter_pdf_0( emitter_7 : u32,  found_7 : Found_0,  vertex_9 : Vertex_0,  direction_20 : vec3<f32>,  t_5 : f32) -> f32
{
    var record_15 : u32 = emitter_record_0(emitter_7);
    if(is_map_0(record_15))
    {
        var _S210 : f32 = map_pdf_0(word_0(record_15 + u32(1)), direction_20);
        return _S210;
    }
    if(!is_area_0(record_15))
    {
        return max(dot(vertex_9.axes_4.n_1, direction_20), 0.0f) * 0.31830987334251404f;
    }
    return area_pdf_0(record_15, found_7.face_7 - word_0(record_15 + u32(3)), vertex_9.surface_3, direction_20, t_5);
}

fn met_0( vertex_10 : Vertex_0,  direction_21 : vec3<f32>,  t_6 : f32,  place_16 : Place_0) -> Place_0
{
    return place_16;
}

fn weight_over_0( own_4 : f32,  other_0 : f32) -> f32
{
    var ratio_0 : f32 = other_0 / own_4;
    if(ratio_0 > 9.9999998430674944e+17f)
    {
        return 0.0f;
    }
    return 1.0f / (own_4 * (1.0f + ratio_0 * ratio_0));
}

fn in_map_0( map_5 : u32,  direction_22 : vec3<f32>) -> Lookup_0
{
    var place_17 : vec2<f32> = map_place_0(map_5, direction_22);
    var point_2 : Point_0;
    point_2.value_3 = place_17;
    var x_12 : i32 = floor_of_0(place_17.x);
    var y_4 : i32 = floor_of_0(place_17.y);
    var width_3 : i32 = i32(word_0(map_5));
    var height_1 : i32 = i32(word_0(map_5 + u32(1)));
    var left_1 : u32 = wrapped_0(x_12, width_3, u32(0));
    var right_1 : u32 = wrapped_0(x_12 + i32(1), width_3, u32(0));
    var _S211 : u32 = wrapped_0(y_4, height_1, u32(2));
    var _S212 : u32 = u32(width_3);
    var first_5 : u32 = _S211 * _S212;
    var _S213 : u32 = wrapped_0(y_4 + i32(1), height_1, u32(2));
    var second_2 : u32 = _S213 * _S212;
    return between_0(vec4<u32>(first_5 + left_1, first_5 + right_1, second_2 + left_1, second_2 + right_1), point_2);
}

fn emitted_0( emitter_8 : u32,  place_18 : Place_0,  direction_23 : vec3<f32>) -> vec3<f32>
{
    var record_16 : u32 = emitter_record_0(emitter_8);
    var texture_6 : u32 = word_0(record_16 + u32(1));
    if(!is_map_0(record_16))
    {
        var _S214 : vec3<f32> = shown_0(texture_6, place_18);
        return _S214;
    }
    var change_1 : vec2<f32> = vec2<f32>(0.0f);
    var factor_0 : vec3<f32> = looked_up_0(word_0(texture_6 + u32(12)), one_texel_0(u32(0)), change_1);
    var _S215 : u32 = word_0(texture_6 + u32(11));
    var _S216 : Lookup_0 = in_map_0(texture_6, value_of_0(direction_23));
    return looked_up_0(_S215, _S216, change_1) * factor_0;
}

fn take_further_0( path_7 : ptr<function, Path_0>,  reflected_1 : ptr<function, Reflected_0>,  importance_0 : vec3<f32>) -> bool
{
    var depth_3 : u32 = launch_0.depth_0;
    var _S217 : u32 = vertex_numbers_0(launch_0.depth_0);
    var incoming_0 : vec3<f32> = value_of_0((*path_7).direction_0);
    var surface_5 : Surface_0 = surface_at_0((*path_7).place_1, incoming_0);
    var material_1 : u32 = material_of_0(surface_5);
    if(material_1 == u32(4294967295))
    {
        return false;
    }
    var vertex_11 : Vertex_0 = vertex_at_0(surface_5, material_1, (*path_7).direction_0);
    var emitter_samples_0 : u32 = word_0(u32(2));
    var _S218 : u32 = word_0(u32(3));
    var _S219 : bool = !reaches_0(depth_3 + u32(3));
    var goes_on_0 : bool;
    if(_S219)
    {
        goes_on_0 = (vertex_11.lobe_1.kind_1) == u32(0);
    }
    else
    {
        goes_on_0 = false;
    }
    if(goes_on_0)
    {
        goes_on_0 = is_sampled_well_0(surface_5.position_0);
    }
    else
    {
        goes_on_0 = false;
    }
    var bsdf_samples_0 : u32;
    if(goes_on_0)
    {
        bsdf_samples_0 = u32(0);
    }
    else
    {
        bsdf_samples_0 = _S218;
    }
    var on_emitters_0 : u32;
    if(has_smooth_0(vertex_11.lobe_1))
    {
        on_emitters_0 = emitter_samples_0;
    }
    else
    {
        on_emitters_0 = u32(0);
    }
    var _S220 : Choice_0 = choice_at_0(surface_5.position_0, vertex_11.axes_4.n_1, on_emitters_0 == u32(0));
    var _S221 : vec3<f32> = vec3<f32>(0.0f);
    goes_on_0 = false;
    var next_2 : Place_0 = (*path_7).place_1;
    var next_direction_0 : vec3<f32> = (*path_7).direction_0;
    var next_rest_0 : vec3<f32> = _S221;
    var i_4 : u32 = u32(0);
    for(;;)
    {
        if(i_4 < (on_emitters_0 + bsdf_samples_0))
        {
        }
        else
        {
            break;
        }
        var sample_3 : LightSample_0;
        var _S222 : bool;
        var goes_on_1 : bool;
        var next_3 : Place_0;
        var next_direction_1 : vec3<f32>;
        var next_rest_1 : vec3<f32>;
        if(i_4 < on_emitters_0)
        {
            var _S223 : bool = sample_emitter_0(vertex_11, _S220, (*path_7).key_0, _S217 + u32(3) * i_4, &(sample_3));
            if(!_S223)
            {
                goes_on_1 = goes_on_0;
                next_3 = next_2;
                next_direction_1 = next_direction_0;
                next_rest_1 = next_rest_0;
                var _S224 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_2 = next_3;
                next_direction_0 = next_direction_1;
                next_rest_0 = next_rest_1;
                i_4 = _S224;
                continue;
            }
        }
        else
        {
            sample_3 = sample_material_0(vertex_11, (*path_7).key_0, first_material_number_0(depth_3) + u32(3) * (i_4 - on_emitters_0));
            if(sample_3.is_specular_0)
            {
                _S222 = (word_0(surface_5.shape_0 + u32(6))) != u32(0);
            }
            else
            {
                _S222 = false;
            }
            if(_S222)
            {
                sample_3.way_1 = mirrored_0(mirror_at_0(surface_5.place_3.triangle_0), incoming_0 + (*path_7).direction_rest_0);
            }
        }
        var moving_1 : vec3<f32>;
        var scattered_4 : Scattered_0 = scattered_along_0(vertex_11, sample_3, walked_of_0((*path_7)), &(moving_1));
        if(!sample_3.is_on_emitter_0)
        {
            _S222 = !((scattered_4.pdf_6) > 0.0f);
        }
        else
        {
            _S222 = false;
        }
        if(_S222)
        {
            goes_on_1 = goes_on_0;
            next_3 = next_2;
            next_direction_1 = next_direction_0;
            next_rest_1 = next_rest_0;
            var _S224 : u32 = i_4 + u32(1);
            goes_on_0 = goes_on_1;
            next_2 = next_3;
            next_direction_0 = next_direction_1;
            next_rest_0 = next_rest_1;
            i_4 = _S224;
            continue;
        }
        var t_7 : f32;
        var found_8 : Found_0 = cast_0(surface_5.exact_0, sample_3.way_1, sample_3.nearest_0, sample_3.farthest_0, sample_3.is_on_emitter_0, &(t_7));
        var own_5 : f32;
        var other_1 : f32;
        if(sample_3.is_on_emitter_0)
        {
            if((found_8.face_7) != u32(4294967295))
            {
                goes_on_1 = goes_on_0;
                next_3 = next_2;
                next_direction_1 = next_direction_0;
                next_rest_1 = next_rest_0;
                var _S224 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_2 = next_3;
                next_direction_0 = next_direction_1;
                next_rest_0 = next_rest_1;
                i_4 = _S224;
                continue;
            }
            var own_6 : f32 = f32(emitter_samples_0) * sample_3.probability_1 * sample_3.pdf_2;
            if(!(own_6 > 0.0f))
            {
                goes_on_1 = goes_on_0;
                next_3 = next_2;
                next_direction_1 = next_direction_0;
                next_rest_1 = next_rest_0;
                var _S224 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_2 = next_3;
                next_direction_0 = next_direction_1;
                next_rest_0 = next_rest_1;
                i_4 = _S224;
                continue;
            }
            var _S225 : f32 = f32(bsdf_samples_0) * scattered_4.pdf_6;
            own_5 = own_6;
            other_1 = _S225;
            goes_on_1 = goes_on_0;
            next_3 = next_2;
            next_direction_1 = next_direction_0;
            next_rest_1 = next_rest_0;
        }
        else
        {
            if(i_4 == on_emitters_0)
            {
                var _S226 : bool = (found_8.face_7) != u32(4294967295);
                var _S227 : Place_0 = place_of_0(found_8);
                (*reflected_1).onward_0 = scattered_4.value_8 * vec3<f32>((1.0f / scattered_4.pdf_6));
                var _S228 : vec3<f32> = sample_3.way_1 - sample_3.direction_9;
                goes_on_1 = _S226;
                next_3 = _S227;
                next_direction_1 = moving_1;
                next_rest_1 = _S228;
            }
            else
            {
                goes_on_1 = goes_on_0;
                next_3 = next_2;
                next_direction_1 = next_direction_0;
                next_rest_1 = next_rest_0;
            }
            var _S229 : u32 = emitter_seen_0(found_8, sample_3.direction_9);
            sample_3.emitter_5 = _S229;
            if(_S229 == u32(4294967295))
            {
                var _S224 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_2 = next_3;
                next_direction_0 = next_direction_1;
                next_rest_0 = next_rest_1;
                i_4 = _S224;
                continue;
            }
            sample_3.place_13 = place_of_0(found_8);
            sample_3.distance_4 = t_7;
            var _S230 : f32 = f32(bsdf_samples_0) * scattered_4.pdf_6;
            var _S231 : bool;
            if(!sample_3.is_specular_0)
            {
                _S231 = emitter_samples_0 != u32(0);
            }
            else
            {
                _S231 = false;
            }
            if(_S231)
            {
                var pdf_7 : f32 = emitter_pdf_0(sample_3.emitter_5, found_8, vertex_11, sample_3.direction_9, t_7);
                own_5 = f32(emitter_samples_0) * chance_of_0(sample_3.emitter_5, _S220) * pdf_7;
            }
            else
            {
                own_5 = 0.0f;
            }
            var _S232 : f32 = own_5;
            own_5 = _S230;
            other_1 = _S232;
        }
        var place_19 : Place_0 = sample_3.place_13;
        var place_20 : Place_0;
        if(is_area_0(emitter_record_0(sample_3.emitter_5)))
        {
            place_20 = met_0(vertex_11, moving_1, sample_3.distance_4, place_19);
        }
        else
        {
            place_20 = place_19;
        }
        var weight_0 : f32 = weight_over_0(own_5, other_1);
        var _S233 : vec3<f32> = emitted_0(sample_3.emitter_5, place_20, moving_1);
        (*reflected_1).direct_0 = (*reflected_1).direct_0 + scattered_4.value_8 * (_S233 * vec3<f32>(weight_0));
        var _S224 : u32 = i_4 + u32(1);
        goes_on_0 = goes_on_1;
        next_2 = next_3;
        next_direction_0 = next_direction_1;
        next_rest_0 = next_rest_1;
        i_4 = _S224;
    }
    if(_S219)
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
    var throughput_1 : vec3<f32> = value_of_0((*path_7).throughput_0) * value_of_0((*reflected_1).onward_0);
    var _S234 : f32 = max(max(throughput_1.x, throughput_1.y), throughput_1.z);
    if(!(_S234 > 0.0f))
    {
        return false;
    }
    var _S235 : u32 = depth_3 + u32(1);
    if(_S235 >= (word_0(u32(1))))
    {
        var survival_0 : f32 = clamp(_S234, 0.0f, 0.94999998807907104f);
        if((random_0((*path_7).key_0, vertex_numbers_0(_S235) - u32(1))) >= survival_0)
        {
            return false;
        }
        (*reflected_1).onward_0 = (*reflected_1).onward_0 * vec3<f32>((1.0f / survival_0));
    }
    (*path_7).place_1 = next_2;
    (*path_7).direction_0 = next_direction_0;
    (*path_7).direction_rest_0 = next_rest_0;
    return true;
}

fn set_word_0( path_8 : u32,  which_6 : u32,  value_9 : u32)
{
    paths_0[which_6 * launch_0.room_0 + path_8] = value_9;
    return;
}

fn set_vector_0( path_9 : u32,  which_7 : ptr<function, u32>,  value_10 : vec3<f32>)
{
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
        set_word_0(path_9, (*which_7) + axis_5, (bitcast<u32>((value_10[axis_5]))));
        axis_5 = axis_5 + u32(1);
    }
    (*which_7) = (*which_7) + u32(3);
    return;
}

fn set_vector_1( path_10 : u32,  which_8 : ptr<function, u32>,  value_11 : vec3<f32>)
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
        set_word_0(path_10, (*which_8) + axis_6, (bitcast<u32>((value_11[axis_6]))));
        axis_6 = axis_6 + u32(1);
    }
    (*which_8) = (*which_8) + u32(3);
    return;
}

fn set_changing_0( path_11 : u32,  which_9 : ptr<function, u32>,  vector_1 : vec3<f32>)
{
    set_vector_1(path_11, &((*which_9)), value_of_0(vector_1));
    return;
}

fn set_place_0( path_12 : u32,  which_10 : ptr<function, u32>,  place_21 : Place_0)
{
    set_word_0(path_12, (*which_10), place_21.triangle_0);
    set_word_0(path_12, (*which_10) + u32(1), (bitcast<u32>((place_21.v_0))));
    set_word_0(path_12, (*which_10) + u32(2), (bitcast<u32>((place_21.w_0))));
    set_word_0(path_12, (*which_10) + u32(3), (bitcast<u32>((place_21.v_rest_0))));
    set_word_0(path_12, (*which_10) + u32(4), (bitcast<u32>((place_21.w_rest_0))));
    (*which_10) = (*which_10) + u32(5);
    return;
}

fn store_0( number_of_path_1 : u32,  path_13 : Path_0)
{
    var at_19 : u32 = u32(1);
    set_changing_0(number_of_path_1, &(at_19), path_13.light_0);
    set_changing_0(number_of_path_1, &(at_19), path_13.throughput_0);
    set_changing_0(number_of_path_1, &(at_19), path_13.direction_0);
    set_place_0(number_of_path_1, &(at_19), path_13.place_1);
    var _S236 : u32 = at_19 + u32(1);
    set_word_0(number_of_path_1, at_19, path_13.key_0.x);
    at_19 = _S236 + u32(1);
    set_word_0(number_of_path_1, _S236, path_13.key_0.y);
    set_vector_0(number_of_path_1, &(at_19), path_13.direction_rest_0);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S237 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S238 : u32 = u32(2) + zero_0;
        _S237 = _S238;
        if(rounds_0 < _S238)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S237;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S239 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

fn take_thread_further_0( thread_0 : u32)
{
    var at_20 : u32 = launch_0.first_0 + thread_0;
    if(at_20 >= (launch_0.end_0))
    {
        return;
    }
    var number_of_path_2 : u32 = input_0[at_20];
    var path_14 : Path_0 = load_0(number_of_path_2);
    var reflected_2 : Reflected_0 = nothing_reflected_0();
    var goes_on_2 : bool = take_further_0(&(path_14), &(reflected_2), vec3<f32>(0.0f));
    path_14.light_0 = path_14.light_0 + path_14.throughput_0 * reflected_2.direct_0;
    path_14.throughput_0 = path_14.throughput_0 * reflected_2.onward_0;
    store_0(number_of_path_2, path_14);
    var _S240 : u32;
    if(goes_on_2)
    {
        _S240 = number_of_path_2;
    }
    else
    {
        _S240 = u32(4294967295);
    }
    set_word_0(at_20, u32(0), _S240);
    check_loops_0();
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn go_on_diffuse(@builtin(global_invocation_id) thread_1 : vec3<u32>)
{
    take_thread_further_0(thread_1.x);
    return;
}
