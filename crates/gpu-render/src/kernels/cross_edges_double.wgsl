// Compiled from boundary.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: e17d2c6c7dee079f
// result: a05f277326f49bdd

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

@binding(2) @group(0) var<storage, read> primitives_0 : array<f64>;

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

struct DiffPair_float_0
{
     primal_0 : f32,
     differential_0 : f32,
};

struct DiffPair_vectorx3Cfloatx2C3x3E_0
{
     primal_0 : vec3<f32>,
     differential_0 : vec3<f32>,
};

fn _d_sqrt_0( dpx_0 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S1 : DiffPair_float_0 = DiffPair_float_0( sqrt(dpx_0.primal_0), 0.5f / sqrt(max(1.00000001168609742e-07f, dpx_0.primal_0)) * dpx_0.differential_0 );
    return _S1;
}

fn s_fwd_length_impl_0( dpx_1 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_float_0
{
    var _S2 : f32 = dpx_1.primal_0[i32(0)];
    var _S3 : f32 = dpx_1.differential_0[i32(0)] * dpx_1.primal_0[i32(0)];
    var _S4 : f32 = dpx_1.primal_0[i32(1)];
    var _S5 : f32 = dpx_1.differential_0[i32(1)] * dpx_1.primal_0[i32(1)];
    var _S6 : f32 = dpx_1.primal_0[i32(2)];
    var _S7 : f32 = dpx_1.differential_0[i32(2)] * dpx_1.primal_0[i32(2)];
    var _S8 : DiffPair_float_0 = DiffPair_float_0( _S2 * _S2 + _S4 * _S4 + _S6 * _S6, _S3 + _S3 + (_S5 + _S5) + (_S7 + _S7) );
    var _S9 : DiffPair_float_0 = _d_sqrt_0(_S8);
    var _S10 : DiffPair_float_0 = DiffPair_float_0( _S9.primal_0, _S9.differential_0 );
    return _S10;
}

fn s_fwd_normalize_impl_0( dpx_2 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S11 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpx_2.primal_0, dpx_2.differential_0 );
    var _S12 : DiffPair_float_0 = s_fwd_length_impl_0(_S11);
    var _S13 : vec3<f32> = vec3<f32>((1.0f / _S12.primal_0));
    var _S14 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpx_2.primal_0 * _S13, dpx_2.differential_0 * _S13 + vec3<f32>(((0.0f - _S12.differential_0) / (_S12.primal_0 * _S12.primal_0))) * dpx_2.primal_0 );
    return _S14;
}

struct DiffPair_vectorx3Cfloatx2C2x3E_0
{
     primal_0 : vec2<f32>,
     differential_0 : vec2<f32>,
};

fn s_fwd_length_impl_1( dpx_3 : DiffPair_vectorx3Cfloatx2C2x3E_0) -> DiffPair_float_0
{
    var _S15 : f32 = dpx_3.primal_0[i32(0)];
    var _S16 : f32 = dpx_3.differential_0[i32(0)] * dpx_3.primal_0[i32(0)];
    var _S17 : f32 = dpx_3.primal_0[i32(1)];
    var _S18 : f32 = dpx_3.differential_0[i32(1)] * dpx_3.primal_0[i32(1)];
    var _S19 : DiffPair_float_0 = DiffPair_float_0( _S15 * _S15 + _S17 * _S17, _S16 + _S16 + (_S18 + _S18) );
    var _S20 : DiffPair_float_0 = _d_sqrt_0(_S19);
    var _S21 : DiffPair_float_0 = DiffPair_float_0( _S20.primal_0, _S20.differential_0 );
    return _S21;
}

fn _d_min_0( dpx_4 : DiffPair_float_0,  dpy_0 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S22 : f32 = min(dpx_4.primal_0, dpy_0.primal_0);
    var _S23 : f32;
    if((dpx_4.primal_0) < (dpy_0.primal_0))
    {
        _S23 = dpx_4.differential_0;
    }
    else
    {
        if((dpx_4.primal_0) > (dpy_0.primal_0))
        {
            _S23 = dpy_0.differential_0;
        }
        else
        {
            _S23 = 0.5f * (dpx_4.differential_0 + dpy_0.differential_0);
        }
    }
    var _S24 : DiffPair_float_0 = DiffPair_float_0( _S22, _S23 );
    return _S24;
}

fn _d_dot_0( dpx_5 : DiffPair_vectorx3Cfloatx2C3x3E_0,  dpy_1 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_float_0
{
    var _S25 : DiffPair_float_0 = DiffPair_float_0( dpx_5.primal_0[i32(0)] * dpy_1.primal_0[i32(0)] + dpx_5.primal_0[i32(1)] * dpy_1.primal_0[i32(1)] + dpx_5.primal_0[i32(2)] * dpy_1.primal_0[i32(2)], dpx_5.primal_0[i32(0)] * dpy_1.differential_0[i32(0)] + dpy_1.primal_0[i32(0)] * dpx_5.differential_0[i32(0)] + dpx_5.primal_0[i32(1)] * dpy_1.differential_0[i32(1)] + dpy_1.primal_0[i32(1)] * dpx_5.differential_0[i32(1)] + dpx_5.primal_0[i32(2)] * dpy_1.differential_0[i32(2)] + dpy_1.primal_0[i32(2)] * dpx_5.differential_0[i32(2)] );
    return _S25;
}

fn _d_max_0( dpx_6 : DiffPair_float_0,  dpy_2 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S26 : f32 = max(dpx_6.primal_0, dpy_2.primal_0);
    var _S27 : f32;
    if((dpx_6.primal_0) > (dpy_2.primal_0))
    {
        _S27 = dpx_6.differential_0;
    }
    else
    {
        if((dpx_6.primal_0) < (dpy_2.primal_0))
        {
            _S27 = dpy_2.differential_0;
        }
        else
        {
            _S27 = 0.5f * (dpx_6.differential_0 + dpy_2.differential_0);
        }
    }
    var _S28 : DiffPair_float_0 = DiffPair_float_0( _S26, _S27 );
    return _S28;
}

fn _d_abs_0( dpx_7 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S29 : DiffPair_float_0 = DiffPair_float_0( abs(dpx_7.primal_0), select(select(-1.0f, 0.0f, (dpx_7.primal_0) == 0.0f), 1.0f, (dpx_7.primal_0) > 0.0f) * dpx_7.differential_0 );
    return _S29;
}

fn _d_cross_0( a_0 : DiffPair_vectorx3Cfloatx2C3x3E_0,  b_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S30 : f32 = a_0.primal_0.y;
    var _S31 : f32 = b_0.primal_0.z;
    var _S32 : f32 = a_0.primal_0.z;
    var _S33 : f32 = b_0.primal_0.y;
    var _S34 : f32 = a_0.differential_0.y;
    var _S35 : f32 = b_0.differential_0.z;
    var _S36 : f32 = a_0.differential_0.z;
    var _S37 : f32 = b_0.differential_0.y;
    var _S38 : f32 = b_0.primal_0.x;
    var _S39 : f32 = a_0.primal_0.x;
    var _S40 : f32 = b_0.differential_0.x;
    var _S41 : f32 = a_0.differential_0.x;
    var _S42 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( vec3<f32>(_S30 * _S31 - _S32 * _S33, _S32 * _S38 - _S39 * _S31, _S39 * _S33 - _S30 * _S38), vec3<f32>(_S34 * _S31 + _S30 * _S35 - _S36 * _S33 - _S32 * _S37, _S36 * _S38 + _S32 * _S40 - _S41 * _S31 - _S39 * _S35, _S41 * _S33 + _S39 * _S37 - _S34 * _S38 - _S30 * _S40) );
    return _S42;
}

fn part_of_launch_0() -> u32
{
    return ((launch_0.depth_0) >> (u32(16)));
}

fn side_path_0( number_of_path_0 : u32,  side_0 : u32) -> u32
{
    return launch_0.room_0 / u32(3) + u32(2) * number_of_path_0 + side_0;
}

fn set_word_0( path_0 : u32,  which_0 : u32,  value_0 : u32)
{
    paths_0[which_0 * launch_0.room_0 + path_0] = value_0;
    return;
}

fn path_word_0( path_1 : u32,  which_1 : u32) -> u32
{
    return paths_0[which_1 * launch_0.room_0 + path_1];
}

fn path_vector_0( path_2 : u32,  which_2 : ptr<function, u32>) -> vec3<f32>
{
    var _S43 : u32 = (*which_2) + u32(3);
    (*which_2) = _S43;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_2, _S43 - u32(3)), path_word_0(path_2, _S43 - u32(2)), path_word_0(path_2, _S43 - u32(1))))));
}

fn path_vector_1( path_3 : u32,  which_3 : ptr<function, u32>) -> vec3<f32>
{
    var _S44 : u32 = (*which_3) + u32(3);
    (*which_3) = _S44;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_3, _S44 - u32(3)), path_word_0(path_3, _S44 - u32(2)), path_word_0(path_3, _S44 - u32(1))))));
}

struct Vector_0
{
     value_1 : vec3<f32>,
     change_0 : vec3<f32>,
};

fn changing_0( value_2 : vec3<f32>,  change_1 : vec3<f32>) -> Vector_0
{
    var vector_0 : Vector_0;
    vector_0.value_1 = value_2;
    vector_0.change_0 = change_1;
    return vector_0;
}

fn path_changing_0( path_4 : u32,  which_4 : ptr<function, u32>) -> Vector_0
{
    var value_3 : vec3<f32> = path_vector_1(path_4, &((*which_4)));
    var _S45 : vec3<f32> = path_vector_1(path_4, &((*which_4)));
    return changing_0(value_3, _S45);
}

struct Place_0
{
     triangle_0 : u32,
     v_0 : f32,
     w_0 : f32,
     v_rest_0 : f32,
     w_rest_0 : f32,
     change_2 : vec2<f32>,
};

fn exact_place_0( triangle_1 : u32,  v_1 : f64,  w_1 : f64) -> Place_0
{
    var place_0 : Place_0;
    place_0.triangle_0 = triangle_1;
    var _S46 : f32 = f32(v_1);
    place_0.v_0 = _S46;
    var _S47 : f32 = f32(w_1);
    place_0.w_0 = _S47;
    place_0.v_rest_0 = f32(v_1 - f64(_S46));
    place_0.w_rest_0 = f32(w_1 - f64(_S47));
    place_0.change_2 = vec2<f32>(0.0f);
    return place_0;
}

fn path_place_0( path_5 : u32,  which_5 : ptr<function, u32>) -> Place_0
{
    var _S48 : u32 = (*which_5) + u32(5);
    (*which_5) = _S48;
    return exact_place_0(path_word_0(path_5, _S48 - u32(5)), f64((bitcast<f32>((path_word_0(path_5, _S48 - u32(4)))))) + f64((bitcast<f32>((path_word_0(path_5, _S48 - u32(2)))))), f64((bitcast<f32>((path_word_0(path_5, _S48 - u32(3)))))) + f64((bitcast<f32>((path_word_0(path_5, _S48 - u32(1)))))));
}

fn change_word_0( at_0 : u32) -> u32
{
    return input_0[launch_0.room_0 + at_0];
}

fn walks_0() -> bool
{
    return (change_word_0(u32(6))) != u32(0);
}

struct Path_0
{
     throughput_0 : Vector_0,
     direction_0 : Vector_0,
     place_1 : Place_0,
     key_0 : vec2<u32>,
     light_0 : Vector_0,
     drift_0 : vec3<f32>,
     walked_0 : vec3<f32>,
     divergence_0 : f32,
};

fn load_0( number_of_path_1 : u32) -> Path_0
{
    var at_1 : u32 = u32(1);
    var path_6 : Path_0;
    var _S49 : Vector_0 = path_changing_0(number_of_path_1, &(at_1));
    path_6.light_0 = _S49;
    var _S50 : Vector_0 = path_changing_0(number_of_path_1, &(at_1));
    path_6.throughput_0 = _S50;
    var _S51 : Vector_0 = path_changing_0(number_of_path_1, &(at_1));
    path_6.direction_0 = _S51;
    var _S52 : vec3<f32> = path_vector_0(number_of_path_1, &(at_1));
    path_6.drift_0 = _S52;
    var _S53 : Place_0 = path_place_0(number_of_path_1, &(at_1));
    path_6.place_1 = _S53;
    path_6.key_0 = vec2<u32>(path_word_0(number_of_path_1, at_1), path_word_0(number_of_path_1, at_1 + u32(1)));
    path_6.walked_0 = vec3<f32>(0.0f);
    path_6.divergence_0 = 0.0f;
    if(walks_0())
    {
        at_1 = u32(29);
        var _S54 : vec3<f32> = path_vector_0(number_of_path_1, &(at_1));
        path_6.walked_0 = _S54;
        path_6.divergence_0 = (bitcast<f32>((path_word_0(number_of_path_1, at_1))));
    }
    return path_6;
}

fn path_at_vertex_0( number_of_path_2 : u32,  factor_0 : ptr<function, vec3<f32>>) -> Path_0
{
    var path_7 : Path_0 = load_0(number_of_path_2);
    (*factor_0) = path_7.throughput_0.value_1;
    return path_7;
}

fn value_of_0( vector_1 : Vector_0) -> vec3<f32>
{
    return vector_1.value_1;
}

fn word_0( at_2 : u32) -> u32
{
    return scene_0[at_2];
}

fn triangle_record_0( triangle_2 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_2;
}

fn shape_of_0( triangle_3 : u32) -> u32
{
    return word_0(u32(10)) + u32(7) * word_0(triangle_record_0(triangle_3));
}

fn primitive_vector_0( at_3 : u32) -> vec3<f64>
{
    return vec3<f64>(primitives_0[at_3], primitives_0[at_3 + u32(1)], primitives_0[at_3 + u32(2)]);
}

fn position_of_0( place_2 : Place_0) -> vec3<f64>
{
    var at_4 : u32 = u32(9) * place_2.triangle_0;
    var a_1 : vec3<f64> = primitive_vector_0(at_4);
    return a_1 + (primitive_vector_0(at_4 + u32(3)) - a_1) * vec3<f64>((f64(place_2.v_0) + f64(place_2.v_rest_0))) + (primitive_vector_0(at_4 + u32(6)) - a_1) * vec3<f64>((f64(place_2.w_0) + f64(place_2.w_rest_0)));
}

fn cross_of_0( triangle_4 : u32) -> vec3<f32>
{
    var at_5 : u32 = u32(9) * triangle_4;
    var a_2 : vec3<f64> = primitive_vector_0(at_5);
    return cross(vec3<f32>(primitive_vector_0(at_5 + u32(3)) - a_2), vec3<f32>(primitive_vector_0(at_5 + u32(6)) - a_2));
}

fn unit_0( v_2 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_2 / vec3<f32>(max(max(abs(v_2.x), abs(v_2.y)), abs(v_2.z))));
}

fn number_0( at_6 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_6])));
}

fn vector_at_0( at_7 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_7), number_0(at_7 + u32(1)), number_0(at_7 + u32(2)));
}

struct Surface_0
{
     place_3 : Place_0,
     shape_0 : u32,
     exact_0 : vec3<f64>,
     position_0 : vec3<f32>,
     face_normal_0 : vec3<f32>,
     outward_0 : vec3<f32>,
     is_front_0 : bool,
     position_change_0 : vec3<f32>,
     outward_change_0 : vec3<f32>,
};

fn surface_at_0( place_4 : Place_0,  direction_1 : vec3<f32>) -> Surface_0
{
    var surface_0 : Surface_0;
    surface_0.place_3 = place_4;
    surface_0.shape_0 = shape_of_0(place_4.triangle_0);
    var _S55 : vec3<f64> = position_of_0(place_4);
    surface_0.exact_0 = _S55;
    surface_0.position_0 = vec3<f32>(_S55);
    var _S56 : vec3<f32> = unit_0(cross_of_0(place_4.triangle_0));
    surface_0.face_normal_0 = _S56;
    surface_0.outward_0 = _S56;
    var seen_0 : f32;
    if((dot(_S56, direction_1)) > 0.0f)
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
        var a_3 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0));
        var b_1 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0 + u32(1)));
        var c_0 : vec3<f32> = vector_at_0(normals_0 + u32(3) * word_0(record_0 + u32(2)));
        if((dot(a_3 + b_1 + c_0, surface_0.face_normal_0)) < 0.0f)
        {
            seen_0 = - seen_0;
        }
        surface_0.outward_0 = normalize(a_3 + (b_1 - a_3) * vec3<f32>(place_4.v_0) + (c_0 - a_3) * vec3<f32>(place_4.w_0));
    }
    surface_0.is_front_0 = seen_0 > 0.0f;
    var _S57 : vec3<f32> = vec3<f32>(0.0f);
    surface_0.outward_change_0 = _S57;
    surface_0.position_change_0 = _S57;
    return surface_0;
}

fn is_moving_0() -> bool
{
    return (change_word_0(u32(0))) != u32(4294967295);
}

fn motion_of_0( triangle_5 : u32) -> u32
{
    return change_word_0(u32(0)) + u32(21) * triangle_5;
}

fn change_vector_0( at_8 : u32) -> vec3<f32>
{
    return (bitcast<vec3<f32>>((vec3<u32>(change_word_0(at_8), change_word_0(at_8 + u32(1)), change_word_0(at_8 + u32(2))))));
}

fn at_place_0( a_4 : vec3<f32>,  b_2 : vec3<f32>,  c_1 : vec3<f32>,  place_5 : Place_0) -> vec3<f32>
{
    return a_4 + (b_2 - a_4) * vec3<f32>(place_5.v_0) + (c_1 - a_4) * vec3<f32>(place_5.w_0);
}

fn move_place_0( place_6 : ptr<function, Place_0>,  position_change_1 : ptr<function, vec3<f32>>,  direction_2 : vec3<f32>,  drift_1 : vec3<f32>)
{
    (*position_change_1) = drift_1;
    if(!is_moving_0())
    {
        return;
    }
    var at_9 : u32 = motion_of_0((*place_6).triangle_0);
    var corner_0 : u32 = u32(9) * (*place_6).triangle_0;
    var of_material_0 : vec3<f32> = at_place_0(change_vector_0(at_9), change_vector_0(at_9 + u32(3)), change_vector_0(at_9 + u32(6)), (*place_6));
    var a_5 : vec3<f64> = primitive_vector_0(corner_0);
    var _S58 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_0 + u32(3)) - a_5);
    var _S59 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_0 + u32(6)) - a_5);
    var across_0 : vec3<f32> = cross(_S58, _S59);
    var _S60 : f32 = max(max(abs(across_0.x), abs(across_0.y)), abs(across_0.z));
    var normal_0 : vec3<f32> = across_0 / vec3<f32>(_S60);
    var slip_0 : vec3<f32> = drift_1 - of_material_0;
    var slip_1 : vec3<f32> = slip_0 - direction_2 * vec3<f32>((dot(normal_0, slip_0) / dot(normal_0, direction_2)));
    (*position_change_1) = of_material_0 + slip_1;
    (*place_6).change_2 = vec2<f32>(dot(slip_1, cross(_S59, normal_0)), dot(slip_1, cross(normal_0, _S58))) * vec2<f32>((1.0f / (dot(normal_0, normal_0) * _S60)));
    return;
}

fn change_of_unit_0( vector_2 : vec3<f32>,  change_3 : vec3<f32>,  size_0 : f32) -> vec3<f32>
{
    return (change_3 - vector_2 * vec3<f32>(dot(vector_2, change_3))) / vec3<f32>(size_0);
}

fn move_surface_0( surface_1 : ptr<function, Surface_0>,  direction_3 : vec3<f32>,  drift_2 : vec3<f32>)
{
    var _S61 : Place_0 = (*surface_1).place_3;
    var _S62 : vec3<f32> = (*surface_1).position_change_0;
    move_place_0(&(_S61), &(_S62), direction_3, drift_2);
    (*surface_1).place_3 = _S61;
    (*surface_1).position_change_0 = _S62;
    if(!is_moving_0())
    {
        return;
    }
    var place_7 : Place_0 = (*surface_1).place_3;
    var at_10 : u32 = motion_of_0((*surface_1).place_3.triangle_0);
    var normals_1 : u32 = word_0((*surface_1).shape_0);
    if(normals_1 == u32(4294967295))
    {
        var corner_1 : u32 = u32(9) * place_7.triangle_0;
        var a_6 : vec3<f64> = primitive_vector_0(corner_1);
        var _S63 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_1 + u32(3)) - a_6);
        var _S64 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_1 + u32(6)) - a_6);
        var a_change_0 : vec3<f32> = change_vector_0(at_10);
        (*surface_1).outward_change_0 = change_of_unit_0((*surface_1).outward_0, cross(change_vector_0(at_10 + u32(3)) - a_change_0, _S64) + cross(_S63, change_vector_0(at_10 + u32(6)) - a_change_0), length(cross(_S63, _S64)));
        return;
    }
    var record_1 : u32 = triangle_record_0(place_7.triangle_0) + u32(2);
    var a_7 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_1));
    var ab_0 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_1 + u32(1))) - a_7;
    var ac_0 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_1 + u32(2))) - a_7;
    var at_11 : u32 = at_10 + u32(9);
    (*surface_1).outward_change_0 = change_of_unit_0((*surface_1).outward_0, at_place_0(change_vector_0(at_11), change_vector_0(at_11 + u32(3)), change_vector_0(at_11 + u32(6)), place_7) + (ab_0 * vec3<f32>(place_7.change_2.x) + ac_0 * vec3<f32>(place_7.change_2.y)), length(a_7 + ab_0 * vec3<f32>(place_7.v_0) + ac_0 * vec3<f32>(place_7.w_0)));
    return;
}

fn material_of_0( surface_2 : Surface_0) -> u32
{
    var _S65 : u32;
    if(surface_2.is_front_0)
    {
        _S65 = u32(2);
    }
    else
    {
        _S65 = u32(3);
    }
    return word_0(surface_2.shape_0 + _S65);
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
    var _S66 : vec3<f32> = vec3<f32>(0.0f);
    numbers_0.k_0 = _S66;
    numbers_0.eta_0 = _S66;
    numbers_0.specular_reflectance_0 = _S66;
    numbers_0.diffuse_reflectance_0 = _S66;
    numbers_0.alpha_0 = vec2<f32>(0.0f);
    return numbers_0;
}

struct Lookup_0
{
     count_0 : u32,
     texels_0 : vec4<u32>,
     weights_0 : vec4<f32>,
     by_first_0 : vec4<f32>,
     by_second_0 : vec4<f32>,
};

fn one_texel_0( texel_0 : u32) -> Lookup_0
{
    var lookup_0 : Lookup_0;
    lookup_0.count_0 = u32(1);
    lookup_0.texels_0 = vec4<u32>(texel_0, u32(0), u32(0), u32(0));
    lookup_0.weights_0 = vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f);
    var _S67 : vec4<f32> = vec4<f32>(0.0f);
    lookup_0.by_second_0 = _S67;
    lookup_0.by_first_0 = _S67;
    return lookup_0;
}

struct Corners2_0
{
     a_8 : vec2<f64>,
     b_3 : vec2<f64>,
     c_2 : vec2<f64>,
};

fn Corners2_x24init_0( a_9 : vec2<f64>,  b_4 : vec2<f64>,  c_3 : vec2<f64>) -> Corners2_0
{
    var _S68 : Corners2_0;
    _S68.a_8 = a_9;
    _S68.b_3 = b_4;
    _S68.c_2 = c_3;
    return _S68;
}

fn precise_0( at_12 : u32) -> f64
{
    return f64(number_0(at_12)) + f64(number_0(at_12 + u32(1)));
}

fn uvs_of_0( triangle_6 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f64>(0.0lf, 0.0lf), vec2<f64>(1.0lf, 0.0lf), vec2<f64>(0.0lf, 1.0lf));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_6) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_13 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_6) + u32(1));
    uvs_0.a_8 = vec2<f64>(precise_0(at_13), precise_0(at_13 + u32(2)));
    uvs_0.b_3 = vec2<f64>(precise_0(at_13 + u32(4)), precise_0(at_13 + u32(6)));
    uvs_0.c_2 = vec2<f64>(precise_0(at_13 + u32(8)), precise_0(at_13 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_14 : u32) -> vec3<f64>
{
    return vec3<f64>(precise_0(at_14), precise_0(at_14 + u32(2)), precise_0(at_14 + u32(4)));
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
     value_4 : vec2<f64>,
     by_first_1 : vec2<f32>,
     by_second_1 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_8 : Point_0) -> Lookup_0
{
    var _S69 : vec2<f32> = vec2<f32>(place_8.value_4 - floor(place_8.value_4));
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - _S69;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S70 : f32 = back_0.x;
    var _S71 : f32 = back_0.y;
    var _S72 : f32 = _S69.x;
    var _S73 : f32 = _S69.y;
    lookup_1.weights_0 = vec4<f32>(_S70 * _S71, _S72 * _S71, _S70 * _S73, _S72 * _S73);
    var by_x_0 : vec4<f32> = vec4<f32>(- _S71, _S71, - _S73, _S73);
    var by_y_0 : vec4<f32> = vec4<f32>(- _S70, - _S72, _S70, _S72);
    lookup_1.by_first_0 = by_x_0 * vec4<f32>(place_8.by_first_1.x) + by_y_0 * vec4<f32>(place_8.by_first_1.y);
    lookup_1.by_second_0 = by_x_0 * vec4<f32>(place_8.by_second_1.x) + by_y_0 * vec4<f32>(place_8.by_second_1.y);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var size_1 : vec2<f32> = vec2<f32>(f32(width_0), f32(height_0));
    var place_9 : vec2<f64> = uv_0.value_4 * vec2<f64>(size_1);
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_9.y), height_0, wrap_1);
        var _S74 : u32 = row_0 * u32(width_0);
        var _S75 : u32 = wrapped_0(floor_of_0(place_9.x), width_0, wrap_1);
        return one_texel_0(_S74 + _S75);
    }
    var centred_0 : Point_0;
    var _S76 : vec2<f64> = place_9 - vec2<f64>(0.5lf);
    centred_0.value_4 = _S76;
    centred_0.by_first_1 = uv_0.by_first_1 * size_1;
    centred_0.by_second_1 = uv_0.by_second_1 * size_1;
    var x_1 : i32 = floor_of_0(_S76.x);
    var y_0 : i32 = floor_of_0(_S76.y);
    var _S77 : u32 = wrapped_0(y_0, height_0, wrap_1);
    var _S78 : u32 = u32(width_0);
    var first_1 : u32 = _S77 * _S78;
    var _S79 : u32 = wrapped_0(y_0 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S79 * _S78;
    var left_0 : u32 = wrapped_0(x_1, width_0, wrap_1);
    var right_0 : u32 = wrapped_0(x_1 + i32(1), width_0, wrap_1);
    return between_0(vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_10 : Place_0) -> Lookup_0
{
    var kind_0 : u32 = word_0(texture_1);
    if(kind_0 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_2 : u32 = triangle_record_0(place_10.triangle_0) + u32(1);
    if(kind_0 == u32(4))
    {
        return one_texel_0(word_0(record_2));
    }
    if(kind_0 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_2 + u32(1)), word_0(record_2 + u32(2)), word_0(record_2 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_10.v_0 - place_10.w_0, place_10.v_0, place_10.w_0, 0.0f);
        lookup_2.by_first_0 = vec4<f32>(-1.0f, 1.0f, 0.0f, 0.0f);
        lookup_2.by_second_0 = vec4<f32>(-1.0f, 0.0f, 1.0f, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_10.triangle_0);
    var by_v_0 : vec2<f64> = uvs_1.b_3 - uvs_1.a_8;
    var by_w_0 : vec2<f64> = uvs_1.c_2 - uvs_1.a_8;
    var _S80 : u32 = texture_1 + u32(6);
    var to_u_0 : vec3<f64> = row_at_0(_S80);
    var to_v_0 : vec3<f64> = row_at_0(_S80 + u32(6));
    var uv_1 : Point_0;
    var _S81 : vec3<f64> = vec3<f64>(uvs_1.a_8 + by_v_0 * vec2<f64>((f64(place_10.v_0) + f64(place_10.v_rest_0))) + by_w_0 * vec2<f64>((f64(place_10.w_0) + f64(place_10.w_rest_0))), 1.0lf);
    uv_1.value_4 = vec2<f64>(dot(_S81, to_u_0), dot(_S81, to_v_0));
    var _S82 : vec2<f64> = to_u_0.xy;
    var _S83 : vec2<f64> = to_v_0.xy;
    uv_1.by_first_1 = vec2<f32>(vec2<f64>(dot(by_v_0, _S82), dot(by_v_0, _S83)));
    uv_1.by_second_1 = vec2<f32>(vec2<f64>(dot(by_w_0, _S82), dot(by_w_0, _S83)));
    if(kind_0 == u32(1))
    {
        var _S84 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S84;
    }
    var half_of_period_0 : vec2<f64> = uv_1.value_4 - floor(uv_1.value_4);
    var _S85 : i32;
    if(((half_of_period_0.x) > 0.5lf) != ((half_of_period_0.y) > 0.5lf))
    {
        _S85 = i32(1);
    }
    else
    {
        _S85 = i32(0);
    }
    return one_texel_0(u32(_S85));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_1 : vec4<f32>) -> vec3<f32>
{
    var _S86 : u32 = word_0(texture_2 + u32(1));
    var _S87 : u32 = texture_2 + u32(19);
    var _S88 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_5 : vec3<f32> = _S88;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_15 : u32 = _S87 + _S86 * lookup_3.texels_0[k_1];
        var _S89 : vec3<f32>;
        if(_S86 == u32(1))
        {
            _S89 = vec3<f32>(number_0(at_15));
        }
        else
        {
            _S89 = vector_at_0(at_15);
        }
        var value_6 : vec3<f32> = value_5 + _S89 * vec3<f32>(weights_1[k_1]);
        k_1 = k_1 + u32(1);
        value_5 = value_6;
    }
    return value_5;
}

fn numbers_of_0( texture_3 : u32) -> u32
{
    return change_word_0(u32(7) + word_0(texture_3 + u32(18)));
}

fn looked_up_0( texture_4 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> Vector_0
{
    var value_7 : vec3<f32> = weighted_texels_0(texture_4, lookup_4, lookup_4.weights_0);
    var change_4 : vec3<f32> = weighted_texels_0(texture_4, lookup_4, lookup_4.by_first_0 * vec4<f32>(place_change_0.x) + lookup_4.by_second_0 * vec4<f32>(place_change_0.y));
    var first_2 : u32 = numbers_of_0(texture_4);
    if(first_2 == u32(4294967295))
    {
        return changing_0(value_7, change_4);
    }
    var _S90 : bool = (word_0(texture_4 + u32(1))) == u32(1);
    var k_2 : u32 = u32(0);
    var change_5 : vec3<f32> = change_4;
    for(;;)
    {
        if(k_2 < (lookup_4.count_0))
        {
        }
        else
        {
            break;
        }
        var _S91 : i32;
        if(_S90)
        {
            _S91 = i32(1);
        }
        else
        {
            _S91 = i32(3);
        }
        var at_16 : u32 = first_2 + u32(_S91) * lookup_4.texels_0[k_2];
        var of_texel_0 : vec3<f32>;
        if(_S90)
        {
            of_texel_0 = (bitcast<vec3<f32>>((vec3<u32>(change_word_0(at_16)))));
        }
        else
        {
            of_texel_0 = change_vector_0(at_16);
        }
        var change_6 : vec3<f32> = change_5 + of_texel_0 * vec3<f32>(lookup_4.weights_0[k_2]);
        k_2 = k_2 + u32(1);
        change_5 = change_6;
    }
    return changing_0(value_7, change_5);
}

fn shown_0( texture_5 : u32,  place_11 : Place_0) -> Vector_0
{
    var _S92 : Lookup_0 = lookup_at_0(texture_5, place_11);
    return looked_up_0(texture_5, _S92, place_11.change_2);
}

fn luminance_0( colour_0 : vec3<f32>) -> f32
{
    return dot(colour_0, vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f));
}

fn set_slot_0( numbers_1 : ptr<function, Numbers_0>,  slot_0 : u32,  value_8 : vec3<f32>)
{
    switch(slot_0)
    {
    case u32(0):
        {
            (*numbers_1).diffuse_reflectance_0 = value_8;
            break;
        }
    case u32(1):
        {
            (*numbers_1).specular_reflectance_0 = value_8;
            break;
        }
    case u32(2):
        {
            (*numbers_1).eta_0 = value_8;
            break;
        }
    case u32(3):
        {
            (*numbers_1).k_0 = value_8;
            break;
        }
    case u32(4):
        {
            (*numbers_1).alpha_0[i32(0)] = luminance_0(value_8);
            break;
        }
    default :
        {
            (*numbers_1).alpha_0[i32(1)] = luminance_0(value_8);
            break;
        }
    }
    return;
}

fn change_of_0( vector_3 : Vector_0) -> vec3<f32>
{
    return vector_3.change_0;
}

struct Lobe_0
{
     record_3 : u32,
     kind_1 : u32,
     distribution_0 : u32,
     numbers_2 : Numbers_0,
     changes_0 : Numbers_0,
};

fn lobe_at_0( record_4 : u32,  place_12 : Place_0) -> Lobe_0
{
    var lobe_0 : Lobe_0;
    lobe_0.record_3 = record_4;
    var is_black_0 : bool = record_4 == u32(4294967295);
    var _S93 : u32;
    if(is_black_0)
    {
        _S93 = u32(0);
    }
    else
    {
        _S93 = word_0(record_4);
    }
    lobe_0.kind_1 = _S93;
    if(is_black_0)
    {
        _S93 = u32(1);
    }
    else
    {
        _S93 = word_0(record_4 + u32(1));
    }
    lobe_0.distribution_0 = _S93;
    var _S94 : Numbers_0 = no_numbers_0();
    lobe_0.numbers_2 = _S94;
    lobe_0.changes_0 = _S94;
    if(is_black_0)
    {
        _S93 = u32(0);
    }
    else
    {
        _S93 = word_0(record_4 + u32(4));
    }
    var slot_1 : u32 = u32(0);
    for(;;)
    {
        if(slot_1 < _S93)
        {
        }
        else
        {
            break;
        }
        var texture_6 : u32 = word_0(record_4 + u32(5) + slot_1);
        if(texture_6 == u32(4294967295))
        {
            slot_1 = slot_1 + u32(1);
            continue;
        }
        var colour_1 : Vector_0 = shown_0(texture_6, place_12);
        var _S95 : vec3<f32> = value_of_0(colour_1);
        var _S96 : Numbers_0 = lobe_0.numbers_2;
        set_slot_0(&(_S96), slot_1, _S95);
        lobe_0.numbers_2 = _S96;
        var _S97 : vec3<f32> = change_of_0(colour_1);
        var _S98 : Numbers_0 = lobe_0.changes_0;
        set_slot_0(&(_S98), slot_1, _S97);
        lobe_0.changes_0 = _S98;
        slot_1 = slot_1 + u32(1);
    }
    return lobe_0;
}

fn tangent_at_0( surface_3 : Surface_0) -> vec3<f32>
{
    var tangents_0 : u32 = word_0(surface_3.shape_0 + u32(5));
    if(tangents_0 == u32(4294967295))
    {
        return vec3<f32>(0.0f);
    }
    var tangent_0 : vec3<f32> = vector_at_0(tangents_0 + u32(3) * word_0(triangle_record_0(surface_3.place_3.triangle_0) + u32(1)));
    var across_1 : vec3<f32> = cross(tangent_0, surface_3.outward_0);
    var _S99 : vec3<f32>;
    if((dot(across_1, across_1)) > 0.0f)
    {
        _S99 = tangent_0;
    }
    else
    {
        _S99 = vec3<f32>(0.0f);
    }
    return _S99;
}

struct Axes_0
{
     s_0 : vec3<f32>,
     t_0 : vec3<f32>,
     n_1 : vec3<f32>,
};

struct DiffPair_Axes_0
{
     primal_0 : Axes_0,
     differential_0 : Axes_0,
};

fn s_fwd_axes_along_0( dpn_0 : DiffPair_vectorx3Cfloatx2C3x3E_0,  dptangent_0 : DiffPair_vectorx3Cfloatx2C3x3E_0,  is_front_1 : bool) -> DiffPair_Axes_0
{
    var _S100 : vec3<f32>;
    var _S101 : vec3<f32>;
    if(is_front_1)
    {
        _S100 = dpn_0.primal_0;
        _S101 = dpn_0.differential_0;
    }
    else
    {
        var _S102 : vec3<f32> = (vec3<f32>(0) - dpn_0.differential_0);
        _S100 = (vec3<f32>(0) - dpn_0.primal_0);
        _S101 = _S102;
    }
    var _S103 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpn_0.primal_0, dpn_0.differential_0 );
    var _S104 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dptangent_0.primal_0, dptangent_0.differential_0 );
    var _S105 : DiffPair_float_0 = _d_dot_0(_S103, _S104);
    var _S106 : vec3<f32> = vec3<f32>(_S105.primal_0);
    var _S107 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dptangent_0.primal_0 - dpn_0.primal_0 * _S106, dptangent_0.differential_0 - (dpn_0.differential_0 * _S106 + vec3<f32>(_S105.differential_0) * dpn_0.primal_0) );
    var _S108 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_normalize_impl_0(_S107);
    var _S109 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( _S108.primal_0, _S108.differential_0 );
    var _S110 : DiffPair_vectorx3Cfloatx2C3x3E_0 = _d_cross_0(_S103, _S109);
    var _S111 : Axes_0 = Axes_0( _S108.primal_0, _S110.primal_0, _S100 );
    var _S112 : Axes_0 = Axes_0( _S108.differential_0, _S110.differential_0, _S101 );
    var _S113 : DiffPair_Axes_0 = DiffPair_Axes_0( _S111, _S112 );
    return _S113;
}

fn s_fwd_axes_around_0( dpn_1 : DiffPair_vectorx3Cfloatx2C3x3E_0,  is_front_2 : bool) -> DiffPair_Axes_0
{
    var _S114 : vec3<f32>;
    var _S115 : vec3<f32>;
    if(is_front_2)
    {
        _S114 = dpn_1.primal_0;
        _S115 = dpn_1.differential_0;
    }
    else
    {
        var _S116 : vec3<f32> = (vec3<f32>(0) - dpn_1.differential_0);
        _S114 = (vec3<f32>(0) - dpn_1.primal_0);
        _S115 = _S116;
    }
    var _S117 : f32 = dpn_1.primal_0.z;
    var _S118 : f32 = dpn_1.differential_0.z;
    var sign_0 : f32;
    if(_S117 < -0.00000999999974738f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var _S119 : f32 = sign_0 + _S117;
    var a_10 : f32 = -1.0f / _S119;
    var s_diff_a_0 : f32 = (0.0f - -1.0f * _S118) / (_S119 * _S119);
    var _S120 : f32 = dpn_1.primal_0.x;
    var _S121 : f32 = dpn_1.differential_0.x;
    var _S122 : f32 = dpn_1.primal_0.y;
    var _S123 : f32 = dpn_1.differential_0.y;
    var _S124 : f32 = _S120 * _S122;
    var b_5 : f32 = _S124 * a_10;
    var s_diff_b_0 : f32 = (_S121 * _S122 + _S123 * _S120) * a_10 + s_diff_a_0 * _S124;
    var _S125 : f32 = sign_0 * _S120;
    var _S126 : f32 = _S125 * _S120;
    var _S127 : f32 = - sign_0;
    var _S128 : f32 = _S122 * _S122;
    var _S129 : f32 = _S123 * _S122;
    var _S130 : Axes_0 = Axes_0( vec3<f32>(1.0f + _S126 * a_10, sign_0 * b_5, _S127 * _S120), vec3<f32>(b_5, sign_0 + _S128 * a_10, - _S122), _S114 );
    var _S131 : Axes_0 = Axes_0( vec3<f32>((_S121 * sign_0 * _S120 + _S121 * _S125) * a_10 + s_diff_a_0 * _S126, s_diff_b_0 * sign_0, _S121 * _S127), vec3<f32>(s_diff_b_0, (_S129 + _S129) * a_10 + s_diff_a_0 * _S128, - _S123), _S115 );
    var _S132 : DiffPair_Axes_0 = DiffPair_Axes_0( _S130, _S131 );
    return _S132;
}

fn to_local_0( axes_0 : Axes_0,  v_3 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(axes_0.s_0, v_3), dot(axes_0.t_0, v_3), dot(axes_0.n_1, v_3));
}

fn s_fwd_to_local_0( dpaxes_0 : DiffPair_Axes_0,  dpv_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S133 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpaxes_0.primal_0.s_0, dpaxes_0.differential_0.s_0 );
    var _S134 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpv_0.primal_0, dpv_0.differential_0 );
    var _S135 : DiffPair_float_0 = _d_dot_0(_S133, _S134);
    var _S136 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpaxes_0.primal_0.t_0, dpaxes_0.differential_0.t_0 );
    var _S137 : DiffPair_float_0 = _d_dot_0(_S136, _S134);
    var _S138 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpaxes_0.primal_0.n_1, dpaxes_0.differential_0.n_1 );
    var _S139 : DiffPair_float_0 = _d_dot_0(_S138, _S134);
    var _S140 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( vec3<f32>(_S135.primal_0, _S137.primal_0, _S139.primal_0), vec3<f32>(_S135.differential_0, _S137.differential_0, _S139.differential_0) );
    return _S140;
}

fn s_fwd_towards_viewer_0( dpaxes_1 : DiffPair_Axes_0,  dpdirection_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S141 : DiffPair_Axes_0 = DiffPair_Axes_0( dpaxes_1.primal_0, dpaxes_1.differential_0 );
    var _S142 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpdirection_0.primal_0, dpdirection_0.differential_0 );
    var _S143 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_to_local_0(_S141, _S142);
    var wi_0 : vec3<f32> = (vec3<f32>(0) - _S143.primal_0);
    var s_diff_wi_0 : vec3<f32> = (vec3<f32>(0) - _S143.differential_0);
    var _S144 : DiffPair_float_0 = DiffPair_float_0( wi_0.z, s_diff_wi_0.z );
    var _S145 : DiffPair_float_0 = _d_abs_0(_S144);
    var _S146 : DiffPair_float_0 = DiffPair_float_0( _S145.primal_0, _S145.differential_0 );
    var _S147 : DiffPair_float_0 = DiffPair_float_0( 9.999999960041972e-13f, 0.0f );
    var _S148 : DiffPair_float_0 = _d_max_0(_S146, _S147);
    var _S149 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( vec3<f32>(wi_0.x, wi_0.y, _S148.primal_0), vec3<f32>(s_diff_wi_0.x, s_diff_wi_0.y, _S148.differential_0) );
    return _S149;
}

struct Vertex_0
{
     surface_4 : Surface_0,
     axes_1 : Axes_0,
     lobe_1 : Lobe_0,
     wi_1 : Vector_0,
     axes_change_0 : Axes_0,
};

fn vertex_at_0( surface_5 : Surface_0,  material_0 : u32,  direction_4 : Vector_0) -> Vertex_0
{
    var vertex_0 : Vertex_0;
    vertex_0.surface_4 = surface_5;
    var _S150 : Lobe_0 = lobe_at_0(material_0, surface_5.place_3);
    vertex_0.lobe_1 = _S150;
    var tangent_1 : vec3<f32> = tangent_at_0(surface_5);
    var _S151 : vec3<f32> = vec3<f32>(0.0f);
    var tangent_change_0 : vec3<f32>;
    if(is_moving_0())
    {
        tangent_change_0 = change_vector_0(motion_of_0(surface_5.place_3.triangle_0) + u32(18));
    }
    else
    {
        tangent_change_0 = _S151;
    }
    var _S152 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( surface_5.outward_0, surface_5.outward_change_0 );
    var axes_2 : DiffPair_Axes_0;
    if((any((tangent_1 != _S151))))
    {
        var _S153 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( tangent_1, tangent_change_0 );
        axes_2 = s_fwd_axes_along_0(_S152, _S153, surface_5.is_front_0);
    }
    else
    {
        axes_2 = s_fwd_axes_around_0(_S152, surface_5.is_front_0);
    }
    vertex_0.axes_1 = axes_2.primal_0;
    vertex_0.axes_change_0 = axes_2.differential_0;
    var _S154 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( value_of_0(direction_4), change_of_0(direction_4) );
    var _S155 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_towards_viewer_0(axes_2, _S154);
    vertex_0.wi_1 = changing_0(_S155.primal_0, _S155.differential_0);
    return vertex_0;
}

fn turns_0( vertex_1 : Vertex_0) -> bool
{
    if((any(((vertex_1.surface_4.position_change_0) != vec3<f32>(0.0f)))))
    {
        return true;
    }
    return (change_word_0(u32(1))) != u32(0);
}

struct VertexMotion_0
{
     velocity_0 : vec3<f32>,
     rotation_0 : vec3<f32>,
};

fn motion_of_1( vertex_2 : Vertex_0) -> VertexMotion_0
{
    var motion_0 : VertexMotion_0;
    motion_0.velocity_0 = vertex_2.surface_4.position_change_0;
    var _S156 : vec3<f32>;
    if(turns_0(vertex_2))
    {
        _S156 = cross(vertex_2.axes_1.n_1, vertex_2.axes_change_0.n_1);
    }
    else
    {
        _S156 = vec3<f32>(0.0f);
    }
    motion_0.rotation_0 = _S156;
    return motion_0;
}

fn has_smooth_0( lobe_2 : Lobe_0) -> bool
{
    return (lobe_2.kind_1) != u32(1);
}

struct ShadingPoint_0
{
     vertex_3 : Vertex_0,
     whole_0 : VertexMotion_0,
     motion_1 : VertexMotion_0,
     purpose_0 : u32,
     emitter_0 : u32,
     tree_0 : u32,
     has_creases_0 : bool,
     turns_1 : bool,
     planes_0 : u32,
     inside_2 : array<vec3<f64>, i32(8)>,
     front_0 : vec3<f32>,
     front_offset_0 : vec3<f32>,
};

fn shading_point_0( path_8 : Path_0,  at_17 : ptr<function, ShadingPoint_0>) -> bool
{
    var direction_5 : vec3<f32> = value_of_0(path_8.direction_0);
    var surface_6 : Surface_0 = surface_at_0(path_8.place_1, direction_5);
    move_surface_0(&(surface_6), direction_5, path_8.drift_0);
    var material_1 : u32 = material_of_0(surface_6);
    var _S157 : Vertex_0 = vertex_at_0(surface_6, material_1, path_8.direction_0);
    (*at_17).vertex_3 = _S157;
    var _S158 : VertexMotion_0 = motion_of_1(_S157);
    (*at_17).motion_1 = _S158;
    (*at_17).whole_0 = _S158;
    (*at_17).planes_0 = u32(0);
    (*at_17).tree_0 = u32(0);
    (*at_17).emitter_0 = u32(0);
    (*at_17).purpose_0 = u32(0);
    (*at_17).turns_1 = false;
    (*at_17).has_creases_0 = false;
    var _S159 : vec3<f32> = vec3<f32>(0.0f);
    (*at_17).front_offset_0 = _S159;
    (*at_17).front_0 = _S159;
    var k_3 : u32 = u32(0);
    for(;;)
    {
        if(k_3 < u32(8))
        {
        }
        else
        {
            break;
        }
        (*at_17).inside_2[k_3] = surface_6.exact_0;
        k_3 = k_3 + u32(1);
    }
    var _S160 : bool;
    if(material_1 != u32(4294967295))
    {
        _S160 = has_smooth_0((*at_17).vertex_3.lobe_1);
    }
    else
    {
        _S160 = false;
    }
    return _S160;
}

struct Crossed_0
{
     factor_1 : vec3<f32>,
     term_0 : vec3<f32>,
     goes_on_0 : vec2<bool>,
};

fn nothing_crossed_0( factor_2 : vec3<f32>) -> Crossed_0
{
    var crossed_0 : Crossed_0;
    crossed_0.factor_1 = factor_2;
    crossed_0.goes_on_0 = vec2<bool>(false, false);
    crossed_0.term_0 = vec3<f32>(0.0f);
    return crossed_0;
}

fn edge_word_0( at_18 : u32) -> u32
{
    return change_word_0(change_word_0(u32(3)) + at_18);
}

fn depth_of_launch_0() -> u32
{
    return ((launch_0.depth_0) & (u32(65535)));
}

fn numbers_for_0( purpose_1 : u32) -> u32
{
    return u32(1073741824) * (purpose_1 + u32(1)) + u32(16) * depth_of_launch_0();
}

fn product_0( a_11 : u32,  b_6 : u32) -> vec2<u32>
{
    var a0_0 : u32 = (a_11 & (u32(65535)));
    var a1_0 : u32 = (a_11 >> (u32(16)));
    var b0_0 : u32 = (b_6 & (u32(65535)));
    var b1_0 : u32 = (b_6 >> (u32(16)));
    var low_0 : u32 = a0_0 * b0_0;
    var middle_0 : u32 = a1_0 * b0_0 + ((low_0 >> (u32(16))));
    var rest_0 : u32 = ((middle_0 & (u32(65535)))) + a0_0 * b1_0;
    return vec2<u32>((((rest_0 << (u32(16)))) | (((low_0 & (u32(65535)))))), a1_0 * b1_0 + ((middle_0 >> (u32(16)))) + ((rest_0 >> (u32(16)))));
}

fn times_0( a_12 : vec2<u32>,  b_7 : vec2<u32>) -> vec2<u32>
{
    var _S161 : u32 = a_12.x;
    var _S162 : u32 = b_7.x;
    var low_1 : vec2<u32> = product_0(_S161, _S162);
    return vec2<u32>(low_1.x, low_1.y + _S161 * b_7.y + a_12.y * _S162);
}

fn plus_0( a_13 : vec2<u32>,  b_8 : vec2<u32>) -> vec2<u32>
{
    var _S163 : u32 = a_13.x;
    var low_2 : u32 = _S163 + b_8.x;
    var _S164 : u32 = a_13.y + b_8.y;
    var _S165 : i32;
    if(low_2 < _S163)
    {
        _S165 = i32(1);
    }
    else
    {
        _S165 = i32(0);
    }
    return vec2<u32>(low_2, _S164 + u32(_S165));
}

fn shifted_xor_0( x_2 : vec2<u32>,  by_0 : u32) -> vec2<u32>
{
    var _S166 : u32 = x_2.y;
    return (x_2 ^ (vec2<u32>(((((x_2.x) >> (by_0))) | (((_S166 << ((u32(32) - by_0)))))), (_S166 >> (by_0)))));
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

fn emitter_record_0( emitter_1 : u32) -> u32
{
    return word_0(u32(11)) + u32(12) * emitter_1;
}

fn is_area_0( record_5 : u32) -> bool
{
    return (word_0(record_5)) == u32(0);
}

fn largest_cosine_0( position_1 : vec3<f32>,  normal_1 : vec3<f32>,  centre_0 : vec3<f32>,  radius_0 : f32) -> f32
{
    var offset_0 : vec3<f32> = centre_0 - position_1;
    var distance_0 : f32 = length(offset_0);
    if(distance_0 <= radius_0)
    {
        return 1.0f;
    }
    var cosine_0 : f32 = dot(offset_0, normal_1) / distance_0;
    var sine_ball_0 : f32 = radius_0 / distance_0;
    var cosine_ball_0 : f32 = sqrt(max(1.0f - sine_ball_0 * sine_ball_0, 0.0f));
    if(cosine_0 >= cosine_ball_0)
    {
        return 1.0f;
    }
    return max(cosine_0 * cosine_ball_0 + sqrt(max(1.0f - cosine_0 * cosine_0, 0.0f)) * sine_ball_0 + 9.99999997475242708e-07f, 0.0f);
}

fn node_seen_0( node_0 : u32,  viewpoint_0 : vec3<f32>) -> f32
{
    var offset_1 : vec3<f32> = viewpoint_0 - vector_at_0(node_0 + u32(4));
    var axis_0 : vec3<f32> = vector_at_0(node_0 + u32(12));
    var radius_1 : f32 = number_0(node_0 + u32(7));
    var area_0 : f32 = number_0(node_0 + u32(11));
    var cosine_spread_0 : f32 = number_0(node_0 + u32(15));
    var sine_spread_0 : f32 = number_0(node_0 + u32(16));
    var squared_0 : f32 = dot(offset_1, offset_1);
    var distance_1 : f32 = sqrt(squared_0);
    if(distance_1 <= radius_1)
    {
        return 0.25f * area_0 / max(radius_1 * radius_1, 1.00000000317107685e-30f);
    }
    var cosine_1 : f32 = clamp(dot(axis_0, offset_1) / distance_1, -1.0f, 1.0f);
    var sine_0 : f32 = sqrt(1.0f - cosine_1 * cosine_1);
    var tilt_0 : f32 = radius_1 / distance_1;
    var highest_0 : f32;
    if(cosine_1 >= cosine_spread_0)
    {
        highest_0 = 1.0f;
    }
    else
    {
        highest_0 = cosine_1 * cosine_spread_0 + sine_0 * sine_spread_0 + tilt_0;
    }
    var lowest_0 : f32;
    if(cosine_1 <= (- cosine_spread_0))
    {
        lowest_0 = -1.0f;
    }
    else
    {
        lowest_0 = cosine_1 * cosine_spread_0 - sine_0 * sine_spread_0 - tilt_0;
    }
    if(highest_0 <= 0.0f)
    {
        return 0.0f;
    }
    if(lowest_0 >= 0.0f)
    {
        return max(dot(vector_at_0(node_0 + u32(8)), offset_1) / distance_1, 0.0f) / squared_0;
    }
    var _S167 : f32 = min(highest_0, 1.0f);
    return area_0 * _S167 * _S167 / (2.0f * (_S167 - max(lowest_0, -1.0f)) * squared_0);
}

fn emitter_view_0( emitter_2 : u32,  position_2 : vec3<f32>,  normal_2 : vec3<f32>) -> f32
{
    var record_6 : u32 = emitter_record_0(emitter_2);
    if(!is_area_0(record_6))
    {
        return 3.14159274101257324f;
    }
    return node_seen_0(word_0(record_6 + u32(5)), position_2) * largest_cosine_0(position_2, normal_2, vector_at_0(record_6 + u32(8)), number_0(record_6 + u32(11)));
}

struct Choice_0
{
     position_3 : vec3<f32>,
     normal_3 : vec3<f32>,
     all_0 : f32,
     lit_0 : f32,
};

fn light_of_0( emitter_3 : u32,  choice_0 : Choice_0,  can_light_0 : ptr<function, f32>) -> f32
{
    var view_0 : f32 = emitter_view_0(emitter_3, choice_0.position_3, choice_0.normal_3);
    var _S168 : f32;
    if(view_0 > 0.0f)
    {
        _S168 = 1.0f;
    }
    else
    {
        _S168 = 0.0f;
    }
    (*can_light_0) = _S168;
    return view_0 * number_0(emitter_record_0(emitter_3) + u32(2));
}

fn chosen_area_emitter_0( vertex_4 : Vertex_0,  u_0 : f32,  probability_0 : ptr<function, f32>) -> u32
{
    var choice_1 : Choice_0;
    choice_1.position_3 = vertex_4.surface_4.position_0;
    choice_1.normal_3 = vertex_4.axes_1.n_1;
    choice_1.all_0 = 0.0f;
    choice_1.lit_0 = 0.0f;
    var _S169 : u32 = word_0(u32(6));
    var can_light_1 : f32;
    var i_1 : u32 = u32(0);
    var count_1 : u32 = u32(0);
    for(;;)
    {
        if(i_1 < _S169)
        {
        }
        else
        {
            break;
        }
        if(!is_area_0(emitter_record_0(i_1)))
        {
            i_1 = i_1 + u32(1);
            continue;
        }
        var _S170 : u32 = count_1 + u32(1);
        if(_S169 > u32(32))
        {
            count_1 = _S170;
            i_1 = i_1 + u32(1);
            continue;
        }
        var _S171 : f32 = light_of_0(i_1, choice_1, &(can_light_1));
        choice_1.all_0 = choice_1.all_0 + _S171;
        choice_1.lit_0 = choice_1.lit_0 + can_light_1;
        count_1 = _S170;
        i_1 = i_1 + u32(1);
    }
    (*probability_0) = 0.0f;
    var _S172 : bool;
    if((choice_1.all_0) > 0.0f)
    {
        _S172 = (choice_1.all_0) < 3.00000000549775576e+38f;
    }
    else
    {
        _S172 = false;
    }
    var _S173 : bool = !_S172;
    var chosen_0 : u32 = u32(0);
    i_1 = u32(0);
    var rest_1 : f32 = u_0;
    for(;;)
    {
        if(i_1 < _S169)
        {
        }
        else
        {
            break;
        }
        if(!is_area_0(emitter_record_0(i_1)))
        {
            i_1 = i_1 + u32(1);
            continue;
        }
        var _S174 : f32 = 1.0f / f32(count_1);
        var own_0 : f32;
        if(!_S173)
        {
            var light_1 : f32 = light_of_0(i_1, choice_1, &(can_light_1));
            own_0 = 0.5f * can_light_1 / choice_1.lit_0 + 0.5f * light_1 / choice_1.all_0;
        }
        else
        {
            own_0 = _S174;
        }
        var chosen_1 : u32;
        if(own_0 > 0.0f)
        {
            (*probability_0) = own_0;
            chosen_1 = i_1;
        }
        else
        {
            chosen_1 = chosen_0;
        }
        if(rest_1 < own_0)
        {
            chosen_0 = chosen_1;
            break;
        }
        var rest_2 : f32 = rest_1 - own_0;
        chosen_0 = chosen_1;
        rest_1 = rest_2;
        i_1 = i_1 + u32(1);
    }
    return chosen_0;
}

fn real_place_0( at_19 : u32) -> u32
{
    return word_0(u32(15)) + u32(4) + at_19;
}

fn edge_real_0( at_20 : u32) -> f64
{
    return primitives_0[real_place_0(at_20)];
}

fn edge_position_0( at_21 : u32) -> vec3<f64>
{
    return primitive_vector_0(real_place_0(at_21));
}

fn exact_unit_0( v_4 : vec3<f64>) -> vec3<f64>
{
    return v_4 / vec3<f64>(sqrt(dot(v_4, v_4)));
}

fn length_of_0( v_5 : vec3<f64>) -> f64
{
    return sqrt(dot(v_5, v_5));
}

fn open_window_0( at_22 : ptr<function, ShadingPoint_0>) -> bool
{
    var window_0 : u32 = edge_word_0(edge_word_0(u32(5)) + (*at_22).emitter_0);
    var corners_0 : u32 = u32(f32(edge_real_0(window_0)));
    var apex_0 : vec3<f64> = (*at_22).vertex_3.surface_4.exact_0;
    var before_0 : vec3<f64>;
    if(corners_0 > u32(0))
    {
        var _S175 : u32 = window_0 + u32(1);
        var normal_4 : vec3<f64> = edge_position_0(_S175);
        var before_1 : vec3<f64> = edge_position_0(_S175 + u32(3) * corners_0) - apex_0;
        if((dot(normal_4, before_1)) >= 0.0lf)
        {
            return false;
        }
        (*at_22).planes_0 = corners_0;
        before_0 = before_1;
        var k_4 : u32 = u32(0);
        for(;;)
        {
            if(k_4 < corners_0)
            {
            }
            else
            {
                break;
            }
            var offset_2 : vec3<f64> = edge_position_0(window_0 + u32(4) + u32(3) * k_4) - apex_0;
            (*at_22).inside_2[k_4] = exact_unit_0(cross(offset_2, before_0));
            var _S176 : u32 = k_4 + u32(1);
            before_0 = offset_2;
            k_4 = _S176;
        }
        (*at_22).front_0 = vec3<f32>(normal_4);
        (*at_22).front_offset_0 = vec3<f32>(before_0);
        return true;
    }
    var offset_3 : vec3<f64> = edge_position_0(window_0 + u32(1)) - apex_0;
    var distance_2 : f64 = length_of_0(offset_3);
    var sine_1 : f64 = edge_real_0(window_0 + u32(4)) / distance_2;
    if(!(sine_1 < 1.0lf))
    {
        return true;
    }
    var cosine_2 : f64 = sqrt(1.0lf - sine_1 * sine_1);
    var axis_1 : vec3<f64> = offset_3 / vec3<f64>(distance_2);
    if((abs(f32(axis_1.x))) < 0.5f)
    {
        before_0 = vec3<f64>(1.0lf, 0.0lf, 0.0lf);
    }
    else
    {
        before_0 = vec3<f64>(0.0lf, 1.0lf, 0.0lf);
    }
    var s_1 : vec3<f64> = exact_unit_0(cross(axis_1, before_0));
    var t_1 : vec3<f64> = cross(axis_1, s_1);
    (*at_22).planes_0 = u32(4);
    var _S177 : vec3<f64> = axis_1 * vec3<f64>(sine_1);
    var _S178 : vec3<f64> = vec3<f64>(cosine_2);
    var _S179 : vec3<f64> = s_1 * _S178;
    (*at_22).inside_2[i32(0)] = _S177 + _S179;
    (*at_22).inside_2[i32(1)] = _S177 - _S179;
    var _S180 : vec3<f64> = t_1 * _S178;
    (*at_22).inside_2[i32(2)] = _S177 + _S180;
    (*at_22).inside_2[i32(3)] = _S177 - _S180;
    return true;
}

fn is_map_0( record_7 : u32) -> bool
{
    return (word_0(record_7)) == u32(2);
}

fn is_blind_0() -> bool
{
    return (change_word_0(u32(4))) != u32(0);
}

fn rests_0( motion_2 : VertexMotion_0) -> bool
{
    var _S181 : vec3<f32> = vec3<f32>(0.0f);
    var _S182 : bool;
    if((all(((motion_2.velocity_0) == _S181))))
    {
        _S182 = (all(((motion_2.rotation_0) == _S181)));
    }
    else
    {
        _S182 = false;
    }
    return _S182;
}

fn turn_to_0( purpose_2 : u32,  key_3 : vec2<u32>,  at_23 : ptr<function, ShadingPoint_0>) -> f32
{
    var probability_1 : f32 = 1.0f;
    (*at_23).purpose_0 = purpose_2;
    (*at_23).planes_0 = u32(0);
    var _S183 : vec3<f32> = vec3<f32>(0.0f);
    (*at_23).front_0 = _S183;
    var _S184 : bool = purpose_2 == u32(2);
    (*at_23).has_creases_0 = _S184;
    var tree_1 : u32;
    if(_S184)
    {
        tree_1 = u32(1);
    }
    else
    {
        tree_1 = u32(0);
    }
    (*at_23).motion_1 = (*at_23).whole_0;
    (*at_23).turns_1 = turns_0((*at_23).vertex_3);
    var _S185 : bool;
    if(purpose_2 == u32(0))
    {
        var _S186 : u32 = edge_word_0(u32(4));
        (*at_23).turns_1 = false;
        var _S187 : u32 = chosen_area_emitter_0((*at_23).vertex_3, random_0(key_3, numbers_for_0(purpose_2)), &(probability_1));
        (*at_23).emitter_0 = _S187;
        if(!(probability_1 > 0.0f))
        {
            _S185 = true;
        }
        else
        {
            var _S188 : bool = open_window_0(&((*at_23)));
            _S185 = !_S188;
        }
        if(_S185)
        {
            return 0.0f;
        }
        tree_1 = _S186;
    }
    else
    {
        if(purpose_2 == u32(1))
        {
            var _S189 : u32 = word_0(u32(8));
            (*at_23).emitter_0 = _S189;
            if(_S189 == u32(4294967295))
            {
                return 0.0f;
            }
            if(is_map_0(emitter_record_0((*at_23).emitter_0)))
            {
                (*at_23).turns_1 = false;
            }
        }
    }
    if(!(*at_23).turns_1)
    {
        (*at_23).motion_1.rotation_0 = _S183;
    }
    if(!is_blind_0())
    {
        _S185 = rests_0((*at_23).motion_1);
    }
    else
    {
        _S185 = false;
    }
    if(_S185)
    {
        tree_1 = tree_1 + u32(2);
    }
    var _S190 : u32 = edge_word_0(tree_1);
    (*at_23).tree_0 = _S190;
    var _S191 : f32;
    if(_S190 == u32(4294967295))
    {
        _S191 = 0.0f;
    }
    else
    {
        _S191 = probability_1;
    }
    return _S191;
}

fn node_at_0( at_24 : ShadingPoint_0,  number_1 : u32) -> u32
{
    return edge_word_0(at_24.tree_0) + u32(45) * number_1;
}

fn precise_random_0( key_4 : vec2<u32>,  dimension_2 : u32) -> f64
{
    var bits_0 : vec2<u32> = random_bits_0(key_4, dimension_2);
    var _S192 : u32 = bits_0.y;
    return (f64((_S192 >> (u32(11)))) + f64((((_S192 << (u32(21)))) | ((((bits_0.x) >> (u32(11))))))) / 2048.0lf / 2048.0lf / 1024.0lf) / 2048.0lf / 1024.0lf;
}

fn edge_number_0( at_25 : u32) -> f32
{
    return (bitcast<f32>((edge_word_0(at_25))));
}

fn edge_vector_0( at_26 : u32) -> vec3<f32>
{
    return vec3<f32>(edge_number_0(at_26), edge_number_0(at_26 + u32(1)), edge_number_0(at_26 + u32(2)));
}

fn may_have_silhouette_0( node_1 : u32,  offset_4 : vec3<f32>,  distance_3 : f32) -> bool
{
    var sine_2 : f32 = edge_number_0(node_1 + u32(11));
    var cosine_3 : f32 = edge_number_0(node_1 + u32(12));
    if(sine_2 > 1.0f)
    {
        return true;
    }
    var margin_0 : f32 = (edge_number_0(node_1 + u32(7)) + 3.99999998990097083e-06f) * cosine_3;
    var margin_1 : f32;
    if(cosine_3 > 0.0f)
    {
        margin_1 = min((edge_number_0(node_1 + u32(13)) + 3.99999998990097083e-06f) / cosine_3, margin_0);
    }
    else
    {
        margin_1 = margin_0;
    }
    return !((abs(dot(edge_vector_0(node_1 + u32(8)), offset_4))) > (sine_2 * distance_3 + margin_1 + 3.99999998990097083e-06f));
}

fn is_outside_0( at_27 : ShadingPoint_0,  offset_5 : vec3<f32>,  radius_2 : f32) -> bool
{
    var _S193 : bool;
    if(u32(0) < (at_27.planes_0))
    {
        _S193 = (dot(vec3<f32>(at_27.inside_2[u32(0)]), offset_5)) < (- radius_2 - 3.99999998990097083e-06f);
    }
    else
    {
        _S193 = false;
    }
    if(_S193)
    {
        return true;
    }
    if(u32(1) < (at_27.planes_0))
    {
        _S193 = (dot(vec3<f32>(at_27.inside_2[u32(1)]), offset_5)) < (- radius_2 - 3.99999998990097083e-06f);
    }
    else
    {
        _S193 = false;
    }
    if(_S193)
    {
        return true;
    }
    if(u32(2) < (at_27.planes_0))
    {
        _S193 = (dot(vec3<f32>(at_27.inside_2[u32(2)]), offset_5)) < (- radius_2 - 3.99999998990097083e-06f);
    }
    else
    {
        _S193 = false;
    }
    if(_S193)
    {
        return true;
    }
    if(u32(3) < (at_27.planes_0))
    {
        _S193 = (dot(vec3<f32>(at_27.inside_2[u32(3)]), offset_5)) < (- radius_2 - 3.99999998990097083e-06f);
    }
    else
    {
        _S193 = false;
    }
    if(_S193)
    {
        return true;
    }
    if(u32(4) < (at_27.planes_0))
    {
        _S193 = (dot(vec3<f32>(at_27.inside_2[u32(4)]), offset_5)) < (- radius_2 - 3.99999998990097083e-06f);
    }
    else
    {
        _S193 = false;
    }
    if(_S193)
    {
        return true;
    }
    if(u32(5) < (at_27.planes_0))
    {
        _S193 = (dot(vec3<f32>(at_27.inside_2[u32(5)]), offset_5)) < (- radius_2 - 3.99999998990097083e-06f);
    }
    else
    {
        _S193 = false;
    }
    if(_S193)
    {
        return true;
    }
    if(u32(6) < (at_27.planes_0))
    {
        _S193 = (dot(vec3<f32>(at_27.inside_2[u32(6)]), offset_5)) < (- radius_2 - 3.99999998990097083e-06f);
    }
    else
    {
        _S193 = false;
    }
    if(_S193)
    {
        return true;
    }
    if(u32(7) < (at_27.planes_0))
    {
        _S193 = (dot(vec3<f32>(at_27.inside_2[u32(7)]), offset_5)) < (- radius_2 - 3.99999998990097083e-06f);
    }
    else
    {
        _S193 = false;
    }
    if(_S193)
    {
        return true;
    }
    return (dot(at_27.front_0, offset_5 - at_27.front_offset_0)) < (- radius_2 - 3.99999998990097083e-06f);
}

fn logarithm_0( x_4 : f32) -> f32
{
    var bits_1 : u32 = (bitcast<u32>((x_4)));
    var power_0 : f32 = f32(i32((bits_1 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((bits_1 & (u32(8388607)))) | (u32(1056964608))))));
    var m_1 : f32;
    var power_1 : f32;
    if(m_0 < 0.70710676908493042f)
    {
        var power_2 : f32 = power_0 - 1.0f;
        m_1 = m_0 + m_0;
        power_1 = power_2;
    }
    else
    {
        m_1 = m_0;
        power_1 = power_0;
    }
    var m_2 : f32 = m_1 - 1.0f;
    var z_0 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * z_0 - 0.00021219444170129f * power_1 - 0.5f * z_0) + 0.693359375f * power_1;
}

fn direction_number_0( d_0 : vec3<f32>) -> u32
{
    var _S194 : i32;
    if((abs(d_0.y)) > (abs(d_0.x)))
    {
        _S194 = i32(1);
    }
    else
    {
        _S194 = i32(0);
    }
    var axis_2 : u32 = u32(_S194);
    var axis_3 : u32;
    if((abs(d_0.z)) > (abs(d_0[axis_2])))
    {
        axis_3 = u32(2);
    }
    else
    {
        axis_3 = axis_2;
    }
    var _S195 : u32 = u32(8) * axis_3;
    if((d_0[axis_3]) < 0.0f)
    {
        _S194 = i32(4);
    }
    else
    {
        _S194 = i32(0);
    }
    var _S196 : u32 = _S195 + u32(_S194);
    if((d_0[(axis_3 + u32(1)) % u32(3)]) < 0.0f)
    {
        _S194 = i32(2);
    }
    else
    {
        _S194 = i32(0);
    }
    var _S197 : u32 = _S196 + u32(_S194);
    if((d_0[(axis_3 + u32(2)) % u32(3)]) < 0.0f)
    {
        _S194 = i32(1);
    }
    else
    {
        _S194 = i32(0);
    }
    return _S197 + u32(_S194);
}

fn velocity_at_0( motion_3 : VertexMotion_0,  offset_6 : vec3<f32>) -> vec3<f32>
{
    return motion_3.velocity_0 + cross(motion_3.rotation_0, offset_6);
}

fn speed_of_0( at_28 : ShadingPoint_0,  node_2 : u32,  offset_7 : vec3<f32>,  radius_3 : f32) -> f32
{
    if(is_blind_0())
    {
        return edge_number_0(node_2 + u32(20)) + 0.10000000149011612f;
    }
    var relative_0 : vec3<f32> = edge_vector_0(node_2 + u32(17)) - velocity_at_0(at_28.motion_1, offset_7);
    var axis_4 : vec3<f32> = edge_vector_0(node_2 + u32(8));
    var sine_3 : f32 = edge_number_0(node_2 + u32(11));
    var cosine_4 : f32 = edge_number_0(node_2 + u32(12));
    var along_0 : f32 = abs(dot(axis_4, relative_0));
    var across_2 : f32 = length(cross(axis_4, relative_0));
    var speed_0 : f32;
    if((across_2 * cosine_4) > (along_0 * sine_3))
    {
        speed_0 = along_0 * cosine_4 + across_2 * sine_3;
    }
    else
    {
        speed_0 = length(relative_0);
    }
    return speed_0 + edge_number_0(node_2 + u32(20)) + length(at_28.motion_1.rotation_0) * radius_3;
}

fn importance_of_0( at_29 : ShadingPoint_0,  node_3 : u32) -> f32
{
    var centre_1 : vec3<f32> = edge_vector_0(node_3 + u32(4));
    var offset_8 : vec3<f32> = centre_1 - at_29.vertex_3.surface_4.position_0;
    var radius_4 : f32 = edge_number_0(node_3 + u32(7));
    var distance_4 : f32 = length(offset_8);
    var _S198 : bool;
    if(!at_29.has_creases_0)
    {
        _S198 = !may_have_silhouette_0(node_3, offset_8, distance_4);
    }
    else
    {
        _S198 = false;
    }
    if(_S198)
    {
        return 0.0f;
    }
    if(is_outside_0(at_29, offset_8, radius_4))
    {
        return 0.0f;
    }
    var cosine_5 : f32 = largest_cosine_0(at_29.vertex_3.surface_4.position_0, at_29.vertex_3.axes_1.n_1, centre_1, radius_4);
    var _S199 : f32 = max(radius_4 * radius_4, 1.00000000317107685e-30f);
    var least_0 : f32 = edge_number_0(node_3 + u32(16));
    var ratio_0 : f32 = _S199 / max(max(distance_4 * distance_4 - _S199, 0.0f) + least_0 * least_0, 1.00000000317107685e-30f);
    var visible_0 : f32;
    if(ratio_0 < 0.00100000004749745f)
    {
        visible_0 = ratio_0 * (1.0f - 0.5f * ratio_0);
    }
    else
    {
        visible_0 = logarithm_0(1.0f + ratio_0);
    }
    var near_0 : f32 = visible_0 / _S199;
    var visible_1 : f32 = edge_number_0(node_3 + u32(14));
    if(distance_4 > (edge_number_0(node_3 + u32(15))))
    {
        visible_0 = visible_1 * edge_number_0(node_3 + u32(21) + direction_number_0((vec3<f32>(0) - offset_8)));
    }
    else
    {
        visible_0 = visible_1;
    }
    return visible_0 * speed_of_0(at_29, node_3, offset_8, radius_4) * cosine_5 * near_0;
}

fn descend_0( at_30 : ShadingPoint_0,  u_1 : f64,  leaf_0 : ptr<function, u32>,  probability_2 : ptr<function, f32>) -> bool
{
    (*leaf_0) = node_at_0(at_30, u32(0));
    (*probability_2) = 1.0f;
    var _S200 : f64 = u_1;
    for(;;)
    {
        if((edge_word_0((*leaf_0))) != u32(4294967295))
        {
        }
        else
        {
            break;
        }
        var first_3 : u32 = (*leaf_0) + u32(45);
        var second_1 : u32 = node_at_0(at_30, edge_word_0((*leaf_0)));
        var of_first_0 : f32 = importance_of_0(at_30, first_3);
        var of_second_0 : f32 = importance_of_0(at_30, second_1);
        var sum_0 : f32 = of_first_0 + of_second_0;
        var _S201 : bool;
        if(sum_0 > 0.0f)
        {
            _S201 = sum_0 < 3.00000000549775576e+38f;
        }
        else
        {
            _S201 = false;
        }
        if(!_S201)
        {
            return false;
        }
        var first_share_0 : f32 = of_first_0 / sum_0;
        var second_share_0 : f32 = of_second_0 / sum_0;
        var _S202 : f64 = f64(first_share_0);
        var is_second_0 : bool;
        if(_S200 >= _S202)
        {
            is_second_0 = second_share_0 > 0.0f;
        }
        else
        {
            is_second_0 = false;
        }
        if(is_second_0)
        {
            _S200 = (_S200 - _S202) / f64(second_share_0);
        }
        else
        {
            _S200 = min(_S200 / _S202, 1.0lf);
        }
        var _S203 : f32;
        if(is_second_0)
        {
            _S203 = second_share_0;
        }
        else
        {
            _S203 = first_share_0;
        }
        (*probability_2) = (*probability_2) * _S203;
        var _S204 : u32;
        if(is_second_0)
        {
            _S204 = second_1;
        }
        else
        {
            _S204 = first_3;
        }
        (*leaf_0) = _S204;
    }
    return true;
}

struct Leaves_0
{
     node_4 : u32,
     end_1 : u32,
};

fn below_0( at_31 : ShadingPoint_0,  node_5 : u32) -> Leaves_0
{
    var leaves_0 : Leaves_0;
    leaves_0.node_4 = node_5;
    leaves_0.end_1 = node_at_0(at_31, edge_word_0(node_5 + u32(1)));
    return leaves_0;
}

fn next_leaf_0( at_32 : ShadingPoint_0,  leaves_1 : ptr<function, Leaves_0>,  leaf_1 : ptr<function, u32>) -> bool
{
    (*leaf_1) = (*leaves_1).node_4;
    for(;;)
    {
        if(((*leaves_1).node_4) < ((*leaves_1).end_1))
        {
        }
        else
        {
            break;
        }
        var _S205 : u32 = (*leaves_1).node_4;
        (*leaf_1) = (*leaves_1).node_4;
        var contributes_0 : bool = (importance_of_0(at_32, _S205)) > 0.0f;
        var is_leaf_0 : bool = (edge_word_0(_S205)) == u32(4294967295);
        var _S206 : bool;
        if(contributes_0)
        {
            _S206 = !is_leaf_0;
        }
        else
        {
            _S206 = false;
        }
        var _S207 : u32;
        if(_S206)
        {
            _S207 = (*leaf_1) + u32(45);
        }
        else
        {
            _S207 = node_at_0(at_32, edge_word_0((*leaf_1) + u32(1)));
        }
        (*leaves_1).node_4 = _S207;
        var _S208 : bool;
        if(contributes_0)
        {
            _S208 = is_leaf_0;
        }
        else
        {
            _S208 = false;
        }
        if(_S208)
        {
            return true;
        }
    }
    return false;
}

struct Edge_0
{
     record_8 : u32,
     numbers_3 : u32,
};

fn edge_at_0( at_33 : ShadingPoint_0,  place_13 : u32) -> Edge_0
{
    var edge_0 : Edge_0;
    edge_0.record_8 = edge_word_0(at_33.tree_0 + u32(1)) + u32(12) * place_13;
    edge_0.numbers_3 = edge_word_0(at_33.tree_0 + u32(2)) + u32(14) * place_13;
    return edge_0;
}

fn sum_of_sizes_0( v_6 : vec3<f64>) -> f64
{
    return abs(v_6.x) + abs(v_6.y) + abs(v_6.z);
}

fn side_seen_0( from_0 : vec3<f64>,  tolerance_0 : f64,  normal_5 : u32,  length_0 : u32) -> i32
{
    var height_1 : f64 = dot(edge_position_0(normal_5), from_0);
    var least_1 : f64 = tolerance_0 * edge_real_0(length_0);
    var _S209 : i32;
    if(height_1 > least_1)
    {
        _S209 = i32(1);
    }
    else
    {
        _S209 = i32(0);
    }
    var _S210 : i32;
    if(height_1 < (- least_1))
    {
        _S210 = i32(1);
    }
    else
    {
        _S210 = i32(0);
    }
    return _S209 - _S210;
}

fn is_silhouette_0( at_34 : ShadingPoint_0,  edge_1 : Edge_0) -> bool
{
    var start_0 : vec3<f64> = edge_position_0(edge_1.numbers_3);
    var tolerance_1 : f64 = edge_real_0(u32(0)) * (sum_of_sizes_0(at_34.vertex_3.surface_4.exact_0) + sum_of_sizes_0(start_0) + edge_real_0(u32(1)));
    var _S211 : vec3<f64> = at_34.vertex_3.surface_4.exact_0 - start_0;
    return (side_seen_0(_S211, tolerance_1, edge_1.numbers_3 + u32(6), edge_1.numbers_3 + u32(12)) * side_seen_0(_S211, tolerance_1, edge_1.numbers_3 + u32(9), edge_1.numbers_3 + u32(13))) <= i32(0);
}

fn factor_of_0( at_35 : ShadingPoint_0,  edge_2 : Edge_0) -> f32
{
    var _S212 : u32 = edge_2.record_8 + u32(2);
    var a_14 : vec3<f32> = edge_vector_0(_S212);
    var b_9 : vec3<f32> = edge_vector_0(_S212 + u32(3));
    var _S213 : bool;
    if(!is_blind_0())
    {
        _S213 = rests_0(at_35.motion_1);
    }
    else
    {
        _S213 = false;
    }
    if(_S213)
    {
        _S213 = (all((a_14 == vec3<f32>(0.0f))));
    }
    else
    {
        _S213 = false;
    }
    if(_S213)
    {
        _S213 = (all((b_9 == vec3<f32>(0.0f))));
    }
    else
    {
        _S213 = false;
    }
    if(_S213)
    {
        return 0.0f;
    }
    if(is_silhouette_0(at_35, edge_2))
    {
        return edge_number_0(edge_2.record_8);
    }
    var _S214 : f32;
    if(at_35.has_creases_0)
    {
        _S214 = edge_number_0(edge_2.record_8 + u32(1));
    }
    else
    {
        _S214 = 0.0f;
    }
    return _S214;
}

fn is_clipped_0( at_36 : ShadingPoint_0,  a_15 : vec3<f64>,  b_10 : vec3<f64>,  range_0 : ptr<function, vec2<f64>>) -> bool
{
    (*range_0) = vec2<f64>(0.0lf, 1.0lf);
    var _S215 : bool;
    if((dot(at_36.front_0, vec3<f32>(a_15) - at_36.front_offset_0)) < -3.99999998990097083e-06f)
    {
        _S215 = (dot(at_36.front_0, vec3<f32>(b_10) - at_36.front_offset_0)) < -3.99999998990097083e-06f;
    }
    else
    {
        _S215 = false;
    }
    if(_S215)
    {
        return true;
    }
    var _S216 : f64 = edge_real_0(u32(2)) * sqrt(max(dot(a_15, a_15), dot(b_10, b_10)));
    var first_4 : f64;
    var second_2 : f64;
    if(u32(0) < (at_36.planes_0))
    {
        var _S217 : f64 = dot(at_36.inside_2[u32(0)], b_10) + _S216;
        first_4 = dot(at_36.inside_2[u32(0)], a_15) + _S216;
        second_2 = _S217;
    }
    else
    {
        first_4 = 1.0lf;
        second_2 = 1.0lf;
    }
    if(first_4 < 0.0lf)
    {
        var _S218 : f64 = (*range_0).x;
        if(second_2 < 0.0lf)
        {
            first_4 = 1.0lf;
        }
        else
        {
            first_4 = first_4 / (first_4 - second_2);
        }
        (*range_0)[i32(0)] = max(_S218, first_4);
    }
    else
    {
        if(second_2 < 0.0lf)
        {
            (*range_0)[i32(1)] = min((*range_0).y, first_4 / (first_4 - second_2));
        }
    }
    if(u32(1) < (at_36.planes_0))
    {
        var _S219 : f64 = dot(at_36.inside_2[u32(1)], b_10) + _S216;
        first_4 = dot(at_36.inside_2[u32(1)], a_15) + _S216;
        second_2 = _S219;
    }
    else
    {
        first_4 = 1.0lf;
        second_2 = 1.0lf;
    }
    if(first_4 < 0.0lf)
    {
        var _S220 : f64 = (*range_0).x;
        if(second_2 < 0.0lf)
        {
            first_4 = 1.0lf;
        }
        else
        {
            first_4 = first_4 / (first_4 - second_2);
        }
        (*range_0)[i32(0)] = max(_S220, first_4);
    }
    else
    {
        if(second_2 < 0.0lf)
        {
            (*range_0)[i32(1)] = min((*range_0).y, first_4 / (first_4 - second_2));
        }
    }
    if(u32(2) < (at_36.planes_0))
    {
        var _S221 : f64 = dot(at_36.inside_2[u32(2)], b_10) + _S216;
        first_4 = dot(at_36.inside_2[u32(2)], a_15) + _S216;
        second_2 = _S221;
    }
    else
    {
        first_4 = 1.0lf;
        second_2 = 1.0lf;
    }
    if(first_4 < 0.0lf)
    {
        var _S222 : f64 = (*range_0).x;
        if(second_2 < 0.0lf)
        {
            first_4 = 1.0lf;
        }
        else
        {
            first_4 = first_4 / (first_4 - second_2);
        }
        (*range_0)[i32(0)] = max(_S222, first_4);
    }
    else
    {
        if(second_2 < 0.0lf)
        {
            (*range_0)[i32(1)] = min((*range_0).y, first_4 / (first_4 - second_2));
        }
    }
    if(u32(3) < (at_36.planes_0))
    {
        var _S223 : f64 = dot(at_36.inside_2[u32(3)], b_10) + _S216;
        first_4 = dot(at_36.inside_2[u32(3)], a_15) + _S216;
        second_2 = _S223;
    }
    else
    {
        first_4 = 1.0lf;
        second_2 = 1.0lf;
    }
    if(first_4 < 0.0lf)
    {
        var _S224 : f64 = (*range_0).x;
        if(second_2 < 0.0lf)
        {
            first_4 = 1.0lf;
        }
        else
        {
            first_4 = first_4 / (first_4 - second_2);
        }
        (*range_0)[i32(0)] = max(_S224, first_4);
    }
    else
    {
        if(second_2 < 0.0lf)
        {
            (*range_0)[i32(1)] = min((*range_0).y, first_4 / (first_4 - second_2));
        }
    }
    if(u32(4) < (at_36.planes_0))
    {
        var _S225 : f64 = dot(at_36.inside_2[u32(4)], b_10) + _S216;
        first_4 = dot(at_36.inside_2[u32(4)], a_15) + _S216;
        second_2 = _S225;
    }
    else
    {
        first_4 = 1.0lf;
        second_2 = 1.0lf;
    }
    if(first_4 < 0.0lf)
    {
        var _S226 : f64 = (*range_0).x;
        if(second_2 < 0.0lf)
        {
            first_4 = 1.0lf;
        }
        else
        {
            first_4 = first_4 / (first_4 - second_2);
        }
        (*range_0)[i32(0)] = max(_S226, first_4);
    }
    else
    {
        if(second_2 < 0.0lf)
        {
            (*range_0)[i32(1)] = min((*range_0).y, first_4 / (first_4 - second_2));
        }
    }
    if(u32(5) < (at_36.planes_0))
    {
        var _S227 : f64 = dot(at_36.inside_2[u32(5)], b_10) + _S216;
        first_4 = dot(at_36.inside_2[u32(5)], a_15) + _S216;
        second_2 = _S227;
    }
    else
    {
        first_4 = 1.0lf;
        second_2 = 1.0lf;
    }
    if(first_4 < 0.0lf)
    {
        var _S228 : f64 = (*range_0).x;
        if(second_2 < 0.0lf)
        {
            first_4 = 1.0lf;
        }
        else
        {
            first_4 = first_4 / (first_4 - second_2);
        }
        (*range_0)[i32(0)] = max(_S228, first_4);
    }
    else
    {
        if(second_2 < 0.0lf)
        {
            (*range_0)[i32(1)] = min((*range_0).y, first_4 / (first_4 - second_2));
        }
    }
    if(u32(6) < (at_36.planes_0))
    {
        var _S229 : f64 = dot(at_36.inside_2[u32(6)], b_10) + _S216;
        first_4 = dot(at_36.inside_2[u32(6)], a_15) + _S216;
        second_2 = _S229;
    }
    else
    {
        first_4 = 1.0lf;
        second_2 = 1.0lf;
    }
    if(first_4 < 0.0lf)
    {
        var _S230 : f64 = (*range_0).x;
        if(second_2 < 0.0lf)
        {
            first_4 = 1.0lf;
        }
        else
        {
            first_4 = first_4 / (first_4 - second_2);
        }
        (*range_0)[i32(0)] = max(_S230, first_4);
    }
    else
    {
        if(second_2 < 0.0lf)
        {
            (*range_0)[i32(1)] = min((*range_0).y, first_4 / (first_4 - second_2));
        }
    }
    if(u32(7) < (at_36.planes_0))
    {
        var _S231 : f64 = dot(at_36.inside_2[u32(7)], b_10) + _S216;
        first_4 = dot(at_36.inside_2[u32(7)], a_15) + _S216;
        second_2 = _S231;
    }
    else
    {
        first_4 = 1.0lf;
        second_2 = 1.0lf;
    }
    if(first_4 < 0.0lf)
    {
        var _S232 : f64 = (*range_0).x;
        if(second_2 < 0.0lf)
        {
            first_4 = 1.0lf;
        }
        else
        {
            first_4 = first_4 / (first_4 - second_2);
        }
        (*range_0)[i32(0)] = max(_S232, first_4);
    }
    else
    {
        if(second_2 < 0.0lf)
        {
            (*range_0)[i32(1)] = min((*range_0).y, first_4 / (first_4 - second_2));
        }
    }
    return !(((*range_0).x) < ((*range_0).y));
}

struct SeenEdge_0
{
     edge_3 : Edge_0,
     start_1 : vec3<f64>,
     along_1 : vec3<f64>,
     range_1 : vec2<f64>,
     near_1 : f64,
     far_0 : f64,
     factor_3 : f32,
     pieces_0 : f32,
     chord_0 : f32,
     from_1 : vec3<f32>,
     to_0 : vec3<f32>,
};

fn see_edge_0( at_37 : ShadingPoint_0,  place_14 : u32,  seen_1 : ptr<function, SeenEdge_0>) -> bool
{
    var _S233 : Edge_0 = edge_at_0(at_37, place_14);
    (*seen_1).edge_3 = _S233;
    var _S234 : vec3<f64> = edge_position_0((*seen_1).edge_3.numbers_3) - at_37.vertex_3.surface_4.exact_0;
    (*seen_1).start_1 = _S234;
    var end_2 : vec3<f64> = edge_position_0((*seen_1).edge_3.numbers_3 + u32(3)) - at_37.vertex_3.surface_4.exact_0;
    (*seen_1).along_1 = end_2 - _S234;
    (*seen_1).far_0 = 1.0lf;
    (*seen_1).near_1 = 1.0lf;
    (*seen_1).chord_0 = 0.0f;
    (*seen_1).pieces_0 = 0.0f;
    var _S235 : vec3<f32> = vec3<f32>(0.0f);
    (*seen_1).to_0 = _S235;
    (*seen_1).from_1 = _S235;
    (*seen_1).range_1 = vec2<f64>(0.0lf, 1.0lf);
    var _S236 : f32 = factor_of_0(at_37, _S233);
    (*seen_1).factor_3 = _S236;
    var _S237 : bool;
    if(!(_S236 > 0.0f))
    {
        _S237 = true;
    }
    else
    {
        var _S238 : vec2<f64> = (*seen_1).range_1;
        var _S239 : bool = is_clipped_0(at_37, (*seen_1).start_1, end_2, &(_S238));
        (*seen_1).range_1 = _S238;
        _S237 = _S239;
    }
    if(_S237)
    {
        return false;
    }
    var first_5 : vec3<f64> = (*seen_1).start_1 + (*seen_1).along_1 * vec3<f64>((*seen_1).range_1.x);
    var last_0 : vec3<f64> = (*seen_1).start_1 + (*seen_1).along_1 * vec3<f64>((*seen_1).range_1.y);
    var _S240 : f64 = sqrt(dot(first_5, first_5));
    (*seen_1).near_1 = _S240;
    (*seen_1).far_0 = sqrt(dot(last_0, last_0));
    if(_S240 > 0.0lf)
    {
        _S237 = ((*seen_1).far_0) > 0.0lf;
    }
    else
    {
        _S237 = false;
    }
    if(!_S237)
    {
        return false;
    }
    (*seen_1).from_1 = vec3<f32>(first_5 / vec3<f64>((*seen_1).near_1));
    (*seen_1).to_0 = vec3<f32>(last_0 / vec3<f64>((*seen_1).far_0));
    (*seen_1).chord_0 = f32(length_of_0(last_0 / vec3<f64>((*seen_1).far_0) - first_5 / vec3<f64>((*seen_1).near_1)));
    var longest_0 : f32;
    if((at_37.vertex_3.lobe_1.kind_1) == u32(0))
    {
        longest_0 = 0.20000000298023224f;
    }
    else
    {
        longest_0 = 0.05000000074505806f;
    }
    (*seen_1).pieces_0 = clamp(ceil((*seen_1).chord_0 / longest_0 - 0.00100000004749745f), 1.0f, 32.0f);
    return true;
}

fn place_between_0( from_2 : f64,  to_1 : f64,  near_2 : f64,  far_1 : f64,  part_0 : f64) -> f64
{
    return from_2 + (to_1 - from_2) * part_0 * near_2 / (part_0 * near_2 + (1.0lf - part_0) * far_1);
}

fn velocity_on_0( at_38 : ShadingPoint_0,  edge_4 : Edge_0,  t_2 : f32,  offset_9 : vec3<f32>) -> vec3<f32>
{
    var _S241 : u32 = edge_4.record_8 + u32(2);
    return mix(edge_vector_0(_S241), edge_vector_0(_S241 + u32(3)), vec3<f32>(t_2)) - velocity_at_0(at_38.motion_1, offset_9);
}

struct Mirrored_0
{
     cosine_6 : f32,
     pdf_0 : f32,
     scattered_0 : f32,
};

fn Mirrored_x24init_0( cosine_7 : f32,  pdf_1 : f32,  scattered_1 : f32) -> Mirrored_0
{
    var _S242 : Mirrored_0;
    _S242.cosine_6 = cosine_7;
    _S242.pdf_0 = pdf_1;
    _S242.scattered_0 = scattered_1;
    return _S242;
}

fn is_rough_0( lobe_3 : Lobe_0) -> bool
{
    var _S243 : bool;
    if((lobe_3.kind_1) == u32(2))
    {
        _S243 = true;
    }
    else
    {
        _S243 = (lobe_3.kind_1) == u32(4);
    }
    return _S243;
}

struct Microfacets_0
{
     distribution_1 : u32,
     alpha_1 : vec2<f32>,
};

fn facets_of_0( lobe_4 : Lobe_0,  numbers_4 : Numbers_0) -> Microfacets_0
{
    var facets_0 : Microfacets_0;
    facets_0.distribution_1 = lobe_4.distribution_0;
    facets_0.alpha_1 = max(numbers_4.alpha_0, vec2<f32>(0.00009999999747379f));
    return facets_0;
}

fn exponential_0( x_5 : f32) -> f32
{
    if(x_5 < -87.0f)
    {
        return 0.0f;
    }
    var power_3 : f32 = floor(x_5 * 1.4426950216293335f + 0.5f);
    var r_0 : f32 = x_5 - power_3 * 0.693359375f + power_3 * 0.00021219444170129f;
    return ((((((0.00019875691214111f * r_0 + 0.00139819993637502f) * r_0 + 0.00833345204591751f) * r_0 + 0.04166579619050026f) * r_0 + 0.1666666567325592f) * r_0 + 0.5f) * r_0 * r_0 + r_0 + 1.0f) * (bitcast<f32>(((u32(i32(power_3) + i32(127)) << (u32(23))))));
}

fn density_0( facets_1 : Microfacets_0,  m_3 : vec3<f32>) -> f32
{
    var _S244 : f32 = m_3.z;
    if(_S244 <= 0.0f)
    {
        return 0.0f;
    }
    var scale_0 : f32 = 3.14159274101257324f * facets_1.alpha_1.x * facets_1.alpha_1.y;
    var slope_0 : vec2<f32> = m_3.xy / facets_1.alpha_1;
    var spread_0 : f32 = dot(slope_0, slope_0);
    var cos2_0 : f32 = _S244 * _S244;
    if((facets_1.distribution_1) == u32(1))
    {
        var sum_1 : f32 = spread_0 + cos2_0;
        return 1.0f / (scale_0 * sum_1 * sum_1);
    }
    var exponent_0 : f32 = spread_0 / cos2_0;
    var _S245 : f32;
    if(exponent_0 > 80.0f)
    {
        _S245 = 0.0f;
    }
    else
    {
        _S245 = exponential_0(- exponent_0) / (scale_0 * cos2_0 * cos2_0);
    }
    return _S245;
}

fn error_function_plus_one_0( x_6 : f32) -> vec2<f32>
{
    var _S246 : f32 = min(abs(x_6), 6.0f);
    var gaussian_0 : f32 = exponential_0(- _S246 * _S246);
    var place_15 : f32 = (_S246 - 2.0f) / (_S246 + 2.0f);
    var complement_0 : f32 = gaussian_0 * (((((((((-0.00042725281673484f * place_15 - 0.00127731403335929f) * place_15 + 0.00131371302995831f) * place_15 + 0.008666617795825f) * place_15 - 0.00805134233087301f) * place_15 - 0.05421232059597969f) * place_15 + 0.1640533059835434f) * place_15 - 0.16603080928325653f) * place_15 - 0.09276388585567474f) * place_15 + 1.27697837352752686f) / (1.0f + 2.0f * _S246);
    var _S247 : f32;
    if(x_6 < 0.0f)
    {
        _S247 = complement_0;
    }
    else
    {
        _S247 = 2.0f - complement_0;
    }
    return vec2<f32>(_S247, 1.128379225730896f * gaussian_0);
}

fn visible_over_cos_0( facets_2 : Microfacets_0,  w_2 : vec3<f32>) -> f32
{
    var stretched_0 : vec2<f32> = w_2.xy * facets_2.alpha_1;
    var spread2_0 : f32 = dot(stretched_0, stretched_0);
    var _S248 : f32 = w_2.z;
    var z2_0 : f32 = _S248 * _S248;
    if((facets_2.distribution_1) == u32(1))
    {
        return 2.0f / (_S248 + sqrt(z2_0 + spread2_0));
    }
    if(z2_0 >= (36.0f * spread2_0))
    {
        return 1.0f / _S248;
    }
    var spread_1 : f32 = sqrt(spread2_0);
    var both_0 : vec2<f32> = error_function_plus_one_0(_S248 / spread_1);
    return 2.0f / (_S248 * both_0.x + 0.5f * spread_1 * both_0.y);
}

fn mirrored_0( facets_3 : Microfacets_0,  wi_2 : vec3<f32>,  wo_0 : vec3<f32>) -> Mirrored_0
{
    var h_0 : vec3<f32> = normalize(wi_2 + wo_0);
    var mirrored_1 : Mirrored_0;
    mirrored_1.cosine_6 = dot(wi_2, h_0);
    var _S249 : f32 = 0.25f * density_0(facets_3, h_0) * visible_over_cos_0(facets_3, wi_2);
    mirrored_1.pdf_0 = _S249;
    mirrored_1.scattered_0 = _S249 * visible_over_cos_0(facets_3, wo_0) * wo_0.z;
    return mirrored_1;
}

fn fresnel_conductor_channel_0( cosine_8 : f32,  eta_1 : f32,  k_5 : f32) -> f32
{
    var cos2_1 : f32 = cosine_8 * cosine_8;
    var sin2_0 : f32 = 1.0f - cos2_1;
    var real_0 : f32 = eta_1 * eta_1 - k_5 * k_5 - sin2_0;
    var product_1 : f32 = eta_1 * k_5;
    var modulus_0 : f32 = sqrt(real_0 * real_0 + 4.0f * (product_1 * product_1));
    if(modulus_0 == 0.0f)
    {
        return 1.0f;
    }
    var larger_0 : f32 = sqrt(0.5f * (modulus_0 + abs(real_0)));
    var smaller_0 : f32 = product_1 / larger_0;
    var _S250 : bool = real_0 < 0.0f;
    var a_16 : f32;
    if(_S250)
    {
        a_16 = smaller_0;
    }
    else
    {
        a_16 = larger_0;
    }
    var b_11 : f32;
    if(_S250)
    {
        b_11 = larger_0;
    }
    else
    {
        b_11 = smaller_0;
    }
    var less_0 : f32 = a_16 - cosine_8;
    var more_0 : f32 = a_16 + cosine_8;
    var _S251 : f32 = b_11 * b_11;
    var p_sum_0 : f32 = modulus_0 * cos2_1 + sin2_0 * sin2_0;
    return (less_0 * less_0 + _S251) / (more_0 * more_0 + _S251) * p_sum_0 / (p_sum_0 + 2.0f * a_16 * cosine_8 * sin2_0);
}

fn fresnel_conductor_0( cosine_9 : f32,  eta_2 : vec3<f32>,  k_6 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(fresnel_conductor_channel_0(cosine_9, eta_2.x, k_6.x), fresnel_conductor_channel_0(cosine_9, eta_2.y, k_6.y), fresnel_conductor_channel_0(cosine_9, eta_2.z, k_6.z));
}

fn coat_eta_0( numbers_5 : Numbers_0) -> f32
{
    return luminance_0(numbers_5.eta_0) / luminance_0(numbers_5.k_0);
}

fn fresnel_dielectric_0( cosine_10 : f32,  eta_3 : f32) -> f32
{
    var eta2_0 : f32 = eta_3 * eta_3;
    var cos2_2 : f32 = cosine_10 * cosine_10;
    var denser_0 : f32 = (eta_3 - 1.0f) * (eta_3 + 1.0f);
    var squared_1 : f32 = denser_0 + cos2_2;
    if(squared_1 <= 0.0f)
    {
        return 1.0f;
    }
    var refracted_0 : f32 = sqrt(squared_1);
    var s_sum_0 : f32 = cosine_10 + refracted_0;
    var p_sum_1 : f32 = eta2_0 * cosine_10 + refracted_0;
    var senkrecht_0 : f32 = denser_0 / (s_sum_0 * s_sum_0);
    var parallel_0 : f32 = denser_0 * ((eta2_0 + 1.0f) * cos2_2 - 1.0f) / (p_sum_1 * p_sum_1);
    return 0.5f * (senkrecht_0 * senkrecht_0 + parallel_0 * parallel_0);
}

fn transmittance_0( lobe_5 : Lobe_0,  eta_4 : f32,  cosine_11 : f32) -> f32
{
    if((lobe_5.kind_1) == u32(3))
    {
        return 1.0f - fresnel_dielectric_0(cosine_11, eta_4);
    }
    var place_16 : f32 = cosine_11 * 63.0f;
    var _S252 : u32 = min(u32(place_16), u32(62));
    var at_39 : u32 = word_0(lobe_5.record_3 + u32(3)) + _S252;
    var here_0 : f32 = number_0(at_39);
    return here_0 + (number_0(at_39 + u32(1)) - here_0) * (place_16 - f32(_S252));
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

fn base_0( lobe_6 : Lobe_0,  eta_6 : f32,  diffuse_0 : vec3<f32>) -> vec3<f32>
{
    var internal_reflectance_0 : f32;
    if((lobe_6.kind_1) == u32(3))
    {
        internal_reflectance_0 = fresnel_diffuse_0(1.0f / eta_6);
    }
    else
    {
        internal_reflectance_0 = number_0(word_0(lobe_6.record_3 + u32(3)) + u32(64));
    }
    if((word_0(lobe_6.record_3 + u32(2))) == u32(0))
    {
        return diffuse_0 * vec3<f32>((1.0f / (1.0f - internal_reflectance_0)));
    }
    return diffuse_0 / (vec3<f32>(1.0f) - diffuse_0 * vec3<f32>(internal_reflectance_0));
}

fn choice_weight_0( colour_2 : vec3<f32>) -> f32
{
    return max((colour_2.x + colour_2.y + colour_2.z) / 3.0f, 0.05000000074505806f);
}

fn base_probability_0( numbers_6 : Numbers_0,  enters_0 : f32) -> f32
{
    var of_base_0 : f32 = enters_0 * choice_weight_0(numbers_6.diffuse_reflectance_0);
    return of_base_0 / (of_base_0 + (1.0f - enters_0) * choice_weight_0(numbers_6.specular_reflectance_0));
}

struct Scattering_0
{
     value_9 : vec3<f32>,
     pdf_2 : f32,
};

fn scattering_0( lobe_7 : Lobe_0,  numbers_7 : Numbers_0,  wi_3 : vec3<f32>,  wo_1 : vec3<f32>) -> Scattering_0
{
    var scattering_1 : Scattering_0;
    var _S253 : f32 = wo_1.z;
    var by_cosine_0 : f32 = _S253 * 0.31830987334251404f;
    if((lobe_7.kind_1) == u32(0))
    {
        scattering_1.value_9 = numbers_7.diffuse_reflectance_0 * vec3<f32>(by_cosine_0);
        scattering_1.pdf_2 = by_cosine_0;
        return scattering_1;
    }
    var _S254 : Mirrored_0 = Mirrored_x24init_0(0.0f, 0.0f, 0.0f);
    var by_facets_0 : Mirrored_0;
    if(is_rough_0(lobe_7))
    {
        by_facets_0 = mirrored_0(facets_of_0(lobe_7, numbers_7), wi_3, wo_1);
    }
    else
    {
        by_facets_0 = _S254;
    }
    if((lobe_7.kind_1) == u32(2))
    {
        scattering_1.value_9 = numbers_7.specular_reflectance_0 * (fresnel_conductor_0(by_facets_0.cosine_6, numbers_7.eta_0, numbers_7.k_0) * vec3<f32>(by_facets_0.scattered_0));
        scattering_1.pdf_2 = by_facets_0.pdf_0;
        return scattering_1;
    }
    var eta_7 : f32 = coat_eta_0(numbers_7);
    var enters_1 : f32 = transmittance_0(lobe_7, eta_7, wi_3.z);
    scattering_1.value_9 = base_0(lobe_7, eta_7, numbers_7.diffuse_reflectance_0) * vec3<f32>((enters_1 * transmittance_0(lobe_7, eta_7, _S253) * by_cosine_0 / (eta_7 * eta_7)));
    var probability_3 : f32 = base_probability_0(numbers_7, enters_1);
    scattering_1.pdf_2 = probability_3 * by_cosine_0;
    if((lobe_7.kind_1) == u32(4))
    {
        scattering_1.value_9 = scattering_1.value_9 + numbers_7.specular_reflectance_0 * vec3<f32>((fresnel_dielectric_0(by_facets_0.cosine_6, eta_7) * by_facets_0.scattered_0));
        scattering_1.pdf_2 = scattering_1.pdf_2 + (1.0f - probability_3) * by_facets_0.pdf_0;
    }
    return scattering_1;
}

fn scattered_values_0( vertex_5 : Vertex_0,  wo_2 : vec3<f32>) -> vec3<f32>
{
    var _S255 : bool;
    if((wo_2.z) <= 0.0f)
    {
        _S255 = true;
    }
    else
    {
        _S255 = !has_smooth_0(vertex_5.lobe_1);
    }
    if(_S255)
    {
        return vec3<f32>(0.0f);
    }
    return scattering_0(vertex_5.lobe_1, vertex_5.lobe_1.numbers_2, value_of_0(vertex_5.wi_1), wo_2).value_9;
}

fn scattered_from_0( vertex_6 : Vertex_0,  direction_6 : vec3<f32>) -> vec3<f32>
{
    return scattered_values_0(vertex_6, to_local_0(vertex_6.axes_1, direction_6));
}

fn largest_0( v_7 : vec3<f32>) -> f32
{
    return max(max(v_7.x, v_7.y), v_7.z);
}

fn still_0( value_10 : vec3<f32>) -> Vector_0
{
    return changing_0(value_10, vec3<f32>(0.0f));
}

fn angle_of_0( x_7 : f32,  y_1 : f32) -> f32
{
    var _S256 : f32 = abs(x_7);
    var _S257 : f32 = abs(y_1);
    var _S258 : f32 = min(_S256, _S257);
    var _S259 : f32 = max(_S256, _S257);
    var is_steep_0 : bool = _S258 > (0.41421356797218323f * _S259);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S258 - _S259;
    }
    else
    {
        above_0 = _S258;
    }
    var below_1 : f32;
    if(is_steep_0)
    {
        below_1 = _S258 + _S259;
    }
    else
    {
        below_1 = _S259;
    }
    if(below_1 > 0.0f)
    {
    }
    else
    {
        below_1 = 1.0f;
    }
    var t_3 : f32 = above_0 / below_1;
    var z_1 : f32 = t_3 * t_3;
    var angle_0 : f32 = (((0.08053744584321976f * z_1 - 0.13877685368061066f) * z_1 + 0.19977711141109467f) * z_1 - 0.33332949876785278f) * z_1 * t_3 + t_3;
    var angle_1 : f32;
    if(is_steep_0)
    {
        angle_1 = angle_0 + 0.78539818525314331f;
    }
    else
    {
        angle_1 = angle_0;
    }
    if(_S257 > _S256)
    {
        angle_1 = 1.57079637050628662f - angle_1;
    }
    if(x_7 < 0.0f)
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

fn s_fwd_angle_of_0( dpx_8 : DiffPair_float_0,  dpy_3 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S260 : DiffPair_float_0 = DiffPair_float_0( dpx_8.primal_0, dpx_8.differential_0 );
    var _S261 : DiffPair_float_0 = _d_abs_0(_S260);
    var _S262 : DiffPair_float_0 = DiffPair_float_0( dpy_3.primal_0, dpy_3.differential_0 );
    var _S263 : DiffPair_float_0 = _d_abs_0(_S262);
    var _S264 : DiffPair_float_0 = DiffPair_float_0( _S261.primal_0, _S261.differential_0 );
    var _S265 : DiffPair_float_0 = DiffPair_float_0( _S263.primal_0, _S263.differential_0 );
    var _S266 : DiffPair_float_0 = _d_min_0(_S264, _S265);
    var _S267 : DiffPair_float_0 = _d_max_0(_S264, _S265);
    var is_steep_1 : bool = (_S266.primal_0) > (0.41421356797218323f * _S267.primal_0);
    var above_1 : f32;
    var s_diff_above_0 : f32;
    if(is_steep_1)
    {
        var _S268 : f32 = _S266.differential_0 - _S267.differential_0;
        above_1 = _S266.primal_0 - _S267.primal_0;
        s_diff_above_0 = _S268;
    }
    else
    {
        above_1 = _S266.primal_0;
        s_diff_above_0 = _S266.differential_0;
    }
    var below_2 : f32;
    var s_diff_below_0 : f32;
    if(is_steep_1)
    {
        var _S269 : f32 = _S266.differential_0 + _S267.differential_0;
        below_2 = _S266.primal_0 + _S267.primal_0;
        s_diff_below_0 = _S269;
    }
    else
    {
        below_2 = _S267.primal_0;
        s_diff_below_0 = _S267.differential_0;
    }
    if(below_2 > 0.0f)
    {
    }
    else
    {
        below_2 = 1.0f;
        s_diff_below_0 = 0.0f;
    }
    var t_4 : f32 = above_1 / below_2;
    var s_diff_t_0 : f32 = (s_diff_above_0 * below_2 - above_1 * s_diff_below_0) / (below_2 * below_2);
    var z_2 : f32 = t_4 * t_4;
    var _S270 : f32 = s_diff_t_0 * t_4;
    var s_diff_z_0 : f32 = _S270 + _S270;
    var _S271 : f32 = 0.08053744584321976f * z_2 - 0.13877685368061066f;
    var _S272 : f32 = _S271 * z_2 + 0.19977711141109467f;
    var tail_0 : f32 = _S272 * z_2 - 0.33332949876785278f;
    var _S273 : f32 = tail_0 * z_2;
    var angle_2 : f32 = _S273 * t_4 + t_4;
    var s_diff_angle_0 : f32 = (((s_diff_z_0 * 0.08053744584321976f * z_2 + s_diff_z_0 * _S271) * z_2 + s_diff_z_0 * _S272) * z_2 + s_diff_z_0 * tail_0) * t_4 + s_diff_t_0 * _S273 + s_diff_t_0;
    var angle_3 : f32;
    if(is_steep_1)
    {
        angle_3 = angle_2 + 0.78539818525314331f;
    }
    else
    {
        angle_3 = angle_2;
    }
    var s_diff_angle_1 : f32;
    if((_S263.primal_0) > (_S261.primal_0))
    {
        var _S274 : f32 = 0.0f - s_diff_angle_0;
        angle_3 = 1.57079637050628662f - angle_3;
        s_diff_angle_1 = _S274;
    }
    else
    {
        s_diff_angle_1 = s_diff_angle_0;
    }
    if((dpx_8.primal_0) < 0.0f)
    {
        var _S275 : f32 = 0.0f - s_diff_angle_1;
        angle_3 = 3.14159274101257324f - angle_3;
        s_diff_angle_1 = _S275;
    }
    if((dpy_3.primal_0) < 0.0f)
    {
        var _S276 : f32 = - s_diff_angle_1;
        above_1 = - angle_3;
        s_diff_above_0 = _S276;
    }
    else
    {
        above_1 = angle_3;
        s_diff_above_0 = s_diff_angle_1;
    }
    var _S277 : DiffPair_float_0 = DiffPair_float_0( above_1, s_diff_above_0 );
    return _S277;
}

fn map_place_0( map_0 : u32,  direction_7 : vec3<f32>) -> vec2<f32>
{
    var _S278 : u32 = map_0 + u32(2);
    var d_1 : vec3<f32> = vector_at_0(_S278) * vec3<f32>(direction_7.x) + vector_at_0(_S278 + u32(3)) * vec3<f32>(direction_7.y) + vector_at_0(_S278 + u32(6)) * vec3<f32>(direction_7.z);
    return vec2<f32>(angle_of_0(- d_1.z, d_1.x) * 0.15915493667125702f * f32(word_0(map_0)) - 0.5f, angle_of_0(d_1.y, length(d_1.xz)) * 0.31830987334251404f * (f32(word_0(map_0 + u32(1))) - 1.0f));
}

fn s_fwd_map_place_0( map_1 : u32,  dpdirection_1 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C2x3E_0
{
    var _S279 : u32 = map_1 + u32(2);
    var _S280 : vec3<f32> = vector_at_0(_S279);
    var _S281 : vec3<f32> = vector_at_0(_S279 + u32(3));
    var _S282 : vec3<f32> = vector_at_0(_S279 + u32(6));
    var d_2 : vec3<f32> = _S280 * vec3<f32>(dpdirection_1.primal_0.x) + _S281 * vec3<f32>(dpdirection_1.primal_0.y) + _S282 * vec3<f32>(dpdirection_1.primal_0.z);
    var s_diff_d_0 : vec3<f32> = vec3<f32>(dpdirection_1.differential_0.x) * _S280 + vec3<f32>(dpdirection_1.differential_0.y) * _S281 + vec3<f32>(dpdirection_1.differential_0.z) * _S282;
    var _S283 : DiffPair_float_0 = DiffPair_float_0( - d_2.z, - s_diff_d_0.z );
    var _S284 : DiffPair_float_0 = DiffPair_float_0( d_2.x, s_diff_d_0.x );
    var _S285 : DiffPair_float_0 = s_fwd_angle_of_0(_S283, _S284);
    var _S286 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( d_2.xz, s_diff_d_0.xz );
    var _S287 : DiffPair_float_0 = s_fwd_length_impl_1(_S286);
    var _S288 : DiffPair_float_0 = DiffPair_float_0( d_2.y, s_diff_d_0.y );
    var _S289 : DiffPair_float_0 = DiffPair_float_0( _S287.primal_0, _S287.differential_0 );
    var _S290 : DiffPair_float_0 = s_fwd_angle_of_0(_S288, _S289);
    var width_1 : f32 = f32(word_0(map_1));
    var _S291 : f32 = f32(word_0(map_1 + u32(1))) - 1.0f;
    var _S292 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( vec2<f32>(_S285.primal_0 * 0.15915493667125702f * width_1 - 0.5f, _S290.primal_0 * 0.31830987334251404f * _S291), vec2<f32>(_S285.differential_0 * 0.15915493667125702f * width_1, _S290.differential_0 * 0.31830987334251404f * _S291) );
    return _S292;
}

fn in_map_0( map_2 : u32,  direction_8 : vec3<f32>) -> Lookup_0
{
    var _S293 : vec2<f64> = vec2<f64>(map_place_0(map_2, direction_8));
    var point_0 : Point_0;
    point_0.value_4 = _S293;
    point_0.by_first_1 = vec2<f32>(1.0f, 0.0f);
    point_0.by_second_1 = vec2<f32>(0.0f, 1.0f);
    var x_8 : i32 = floor_of_0(_S293.x);
    var y_2 : i32 = floor_of_0(_S293.y);
    var width_2 : i32 = i32(word_0(map_2));
    var height_2 : i32 = i32(word_0(map_2 + u32(1)));
    var left_1 : u32 = wrapped_0(x_8, width_2, u32(0));
    var right_1 : u32 = wrapped_0(x_8 + i32(1), width_2, u32(0));
    var _S294 : u32 = wrapped_0(y_2, height_2, u32(2));
    var _S295 : u32 = u32(width_2);
    var first_6 : u32 = _S294 * _S295;
    var _S296 : u32 = wrapped_0(y_2 + i32(1), height_2, u32(2));
    var second_3 : u32 = _S296 * _S295;
    return between_0(vec4<u32>(first_6 + left_1, first_6 + right_1, second_3 + left_1, second_3 + right_1), point_0);
}

fn x2A_0( a_17 : Vector_0,  b_12 : Vector_0) -> Vector_0
{
    return changing_0(a_17.value_1 * b_12.value_1, a_17.change_0 * b_12.value_1 + a_17.value_1 * b_12.change_0);
}

fn emitted_0( emitter_4 : u32,  place_17 : Place_0,  direction_9 : Vector_0) -> Vector_0
{
    var record_9 : u32 = emitter_record_0(emitter_4);
    var texture_7 : u32 = word_0(record_9 + u32(1));
    if(!is_map_0(record_9))
    {
        var _S297 : Vector_0 = shown_0(texture_7, place_17);
        return _S297;
    }
    var _S298 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( direction_9.value_1, direction_9.change_0 );
    var _S299 : DiffPair_vectorx3Cfloatx2C2x3E_0 = s_fwd_map_place_0(texture_7, _S298);
    var factor_4 : Vector_0 = looked_up_0(word_0(texture_7 + u32(12)), one_texel_0(u32(0)), vec2<f32>(0.0f));
    var _S300 : u32 = word_0(texture_7 + u32(11));
    var _S301 : Lookup_0 = in_map_0(texture_7, value_of_0(direction_9));
    return x2A_0(looked_up_0(_S300, _S301, _S299.differential_0), factor_4);
}

fn light_from_0( at_40 : ShadingPoint_0,  direction_10 : vec3<f32>) -> f32
{
    var light_2 : f32 = largest_0(scattered_from_0(at_40.vertex_3, direction_10));
    var _S302 : bool;
    if((at_40.purpose_0) != u32(1))
    {
        _S302 = true;
    }
    else
    {
        _S302 = !(light_2 > 0.0f);
    }
    if(_S302)
    {
        return light_2;
    }
    var _S303 : Vector_0 = emitted_0(at_40.emitter_0, at_40.vertex_3.surface_4.place_3, still_0(direction_10));
    return light_2 * largest_0(value_of_0(_S303));
}

fn weigh_0( at_41 : ShadingPoint_0,  seen_2 : SeenEdge_0,  piece_0 : f32) -> vec2<f32>
{
    var part_1 : f32 = (piece_0 + 0.5f) / seen_2.pieces_0;
    var middle_1 : vec3<f32> = normalize(mix(seen_2.from_1, seen_2.to_0, vec3<f32>(part_1)));
    var t_5 : f32 = f32(place_between_0(seen_2.range_1.x, seen_2.range_1.y, seen_2.near_1, seen_2.far_0, f64(part_1)));
    var _S304 : vec3<f32> = vec3<f32>(seen_2.start_1 + seen_2.along_1 * vec3<f64>(f64(t_5)));
    var _S305 : vec3<f32> = vec3<f32>(exact_unit_0(cross(seen_2.start_1, seen_2.along_1)));
    var _S306 : f32 = edge_number_0(seen_2.edge_3.record_8 + u32(10));
    var speed_1 : f32;
    if(!is_blind_0())
    {
        speed_1 = abs(dot(velocity_on_0(at_41, seen_2.edge_3, t_5, _S304), _S305));
    }
    else
    {
        speed_1 = _S306;
    }
    var speed_2 : f32 = speed_1 / length(_S304);
    var angle_4 : f32 = seen_2.factor_3 * seen_2.chord_0 / seen_2.pieces_0;
    var _S307 : f32 = light_from_0(at_41, middle_1);
    var contribution_0 : f32 = angle_4 * _S307 * speed_2;
    var _S308 : vec2<f32>;
    if(contribution_0 < 3.00000000549775576e+38f)
    {
        _S308 = vec2<f32>(contribution_0, angle_4);
    }
    else
    {
        _S308 = vec2<f32>(0.0f);
    }
    return _S308;
}

fn multiplicity_0( at_42 : ShadingPoint_0,  edge_5 : Edge_0,  direction_11 : vec3<f64>,  normal_6 : vec3<f64>) -> f32
{
    var _S309 : vec3<f64> = cross(normal_6, direction_11);
    var _S310 : u32 = edge_5.record_8 + u32(8);
    var k_7 : u32 = edge_word_0(_S310);
    var count_2 : f32 = 1.0f;
    for(;;)
    {
        if(k_7 < (edge_word_0(_S310 + u32(1))))
        {
        }
        else
        {
            break;
        }
        var other_0 : Edge_0 = edge_at_0(at_42, edge_word_0(k_7));
        if(!((factor_of_0(at_42, other_0)) > 0.0f))
        {
            k_7 = k_7 + u32(1);
            continue;
        }
        var a_18 : vec3<f64> = edge_position_0(other_0.numbers_3) - at_42.vertex_3.surface_4.exact_0;
        var way_0 : vec3<f64> = edge_position_0(other_0.numbers_3 + u32(3)) - at_42.vertex_3.surface_4.exact_0 - a_18;
        var place_18 : f64 = - dot(a_18, _S309) / dot(way_0, _S309);
        var there_0 : vec3<f64> = a_18 + way_0 * vec3<f64>(place_18);
        var _S311 : bool;
        if(place_18 >= 0.0lf)
        {
            _S311 = place_18 <= 1.0lf;
        }
        else
        {
            _S311 = false;
        }
        var _S312 : bool;
        if(_S311)
        {
            _S312 = (dot(there_0, direction_11)) > 0.0lf;
        }
        else
        {
            _S312 = false;
        }
        if(!_S312)
        {
            k_7 = k_7 + u32(1);
            continue;
        }
        if(!((abs(dot(normal_6, there_0))) <= (edge_real_0(u32(3)) * length_of_0(there_0))))
        {
            k_7 = k_7 + u32(1);
            continue;
        }
        var count_3 : f32;
        if(f32(abs(dot(normal_6, exact_unit_0(cross(a_18, way_0))))) > 0.99999898672103882f)
        {
            count_3 = count_2 + 1.0f;
        }
        else
        {
            count_3 = count_2;
        }
        count_2 = count_3;
        k_7 = k_7 + u32(1);
    }
    return count_2;
}

fn face_normal_1( at_43 : ShadingPoint_0) -> vec3<f64>
{
    var corners_1 : u32 = u32(9) * at_43.vertex_3.surface_4.place_3.triangle_0;
    var a_19 : vec3<f64> = primitive_vector_0(corners_1);
    return exact_unit_0(cross(primitive_vector_0(corners_1 + u32(3)) - a_19, primitive_vector_0(corners_1 + u32(6)) - a_19));
}

fn limit_at_0( which_6 : u32) -> f64
{
    return primitives_0[word_0(u32(15)) + which_6];
}

struct EdgePoint_0
{
     edge_6 : Edge_0,
     t_6 : f32,
     direction_12 : vec3<f64>,
     normal_7 : vec3<f64>,
     distance_5 : f64,
     measure_0 : f32,
     is_in_horizon_0 : bool,
};

fn point_on_0( at_44 : ShadingPoint_0,  seen_3 : SeenEdge_0,  piece_1 : f32,  inside_3 : f64,  part_of_all_0 : f32) -> EdgePoint_0
{
    var _S313 : f64 = seen_3.range_1.x;
    var _S314 : f64 = seen_3.range_1.y;
    var _S315 : f64 = f64(seen_3.pieces_0);
    var first_7 : f64 = place_between_0(_S313, _S314, seen_3.near_1, seen_3.far_0, f64(piece_1) / _S315);
    var last_1 : f64 = place_between_0(_S313, _S314, seen_3.near_1, seen_3.far_0, f64(piece_1 + 1.0f) / _S315);
    var a_20 : vec3<f64> = seen_3.start_1 + seen_3.along_1 * vec3<f64>(first_7);
    var b_13 : vec3<f64> = seen_3.start_1 + seen_3.along_1 * vec3<f64>(last_1);
    var near_3 : f64 = length_of_0(a_20);
    var far_2 : f64 = length_of_0(b_13);
    var from_3 : vec3<f64> = a_20 / vec3<f64>(near_3);
    var chord_1 : vec3<f64> = b_13 / vec3<f64>(far_2) - from_3;
    var on_chord_0 : vec3<f64> = from_3 + chord_1 * vec3<f64>(inside_3);
    var angle_5 : f64 = length_of_0(cross(from_3, chord_1)) / dot(on_chord_0, on_chord_0);
    var t_7 : f64 = place_between_0(first_7, last_1, near_3, far_2, inside_3);
    var offset_10 : vec3<f64> = seen_3.start_1 + seen_3.along_1 * vec3<f64>(t_7);
    var point_1 : EdgePoint_0;
    var _S316 : f64 = length_of_0(offset_10);
    point_1.distance_5 = _S316;
    var _S317 : vec3<f64> = offset_10 / vec3<f64>(_S316);
    point_1.direction_12 = _S317;
    var _S318 : vec3<f64> = exact_unit_0(cross(seen_3.start_1, seen_3.along_1));
    point_1.normal_7 = _S318;
    point_1.edge_6 = seen_3.edge_3;
    point_1.t_6 = f32(t_7);
    point_1.measure_0 = f32(angle_5 / _S316) / (part_of_all_0 * multiplicity_0(at_44, seen_3.edge_3, _S317, _S318));
    var face_0 : vec3<f64> = face_normal_1(at_44);
    var least_2 : f64 = limit_at_0(u32(2));
    var _S319 : bool;
    if((abs(dot(seen_3.start_1, face_0))) <= least_2)
    {
        _S319 = (abs(dot(seen_3.start_1 + seen_3.along_1, face_0))) <= least_2;
    }
    else
    {
        _S319 = false;
    }
    point_1.is_in_horizon_0 = _S319;
    return point_1;
}

fn offset_of_0( point_2 : EdgePoint_0) -> vec3<f32>
{
    return vec3<f32>(point_2.direction_12 * vec3<f64>(point_2.distance_5));
}

fn flow_at_0( at_45 : ShadingPoint_0,  point_3 : EdgePoint_0) -> f32
{
    return f32(dot(vec3<f64>(velocity_on_0(at_45, point_3.edge_6, point_3.t_6, offset_of_0(point_3))), point_3.normal_7)) * point_3.measure_0;
}

fn component_0( v_8 : vec3<f64>,  axis_5 : u32) -> f64
{
    var _S320 : f64;
    if(axis_5 == u32(0))
    {
        _S320 = v_8.x;
    }
    else
    {
        if(axis_5 == u32(1))
        {
            _S320 = v_8.y;
        }
        else
        {
            _S320 = v_8.z;
        }
    }
    return _S320;
}

struct Ray_0
{
     origin_0 : vec3<f64>,
     shear_x_0 : f64,
     shear_y_0 : f64,
     inverse_z_0 : f64,
     t_min_0 : f64,
     t_max_0 : f64,
     local_per_t_0 : f64,
     enter_0 : f64,
     edge_on_0 : f64,
     largest_1 : f64,
};

fn ray_along_0( origin_1 : vec3<f64>,  direction_13 : vec3<f64>,  t_min_1 : f64,  t_max_1 : f64,  axes_3 : ptr<function, u32>) -> Ray_0
{
    var size_2 : vec3<f32> = abs(vec3<f32>(direction_13));
    var _S321 : f32 = size_2.x;
    var _S322 : f32 = size_2.y;
    var _S323 : bool;
    if(_S321 >= _S322)
    {
        _S323 = _S321 >= (size_2.z);
    }
    else
    {
        _S323 = false;
    }
    var _S324 : i32;
    if(_S323)
    {
        _S324 = i32(0);
    }
    else
    {
        if(_S322 >= (size_2.z))
        {
            _S324 = i32(1);
        }
        else
        {
            _S324 = i32(2);
        }
    }
    var z_3 : u32 = u32(_S324);
    var x_9 : u32 = (z_3 + u32(1)) % u32(3);
    var y_3 : u32 = (z_3 + u32(2)) % u32(3);
    (*axes_3) = (((x_9 | (((y_3 << (u32(2))))))) | (((z_3 << (u32(4))))));
    var ray_0 : Ray_0;
    ray_0.origin_0 = origin_1;
    var along_2 : f64 = component_0(direction_13, z_3);
    ray_0.inverse_z_0 = 1.0lf / along_2;
    ray_0.shear_x_0 = component_0(direction_13, x_9) / along_2;
    ray_0.shear_y_0 = component_0(direction_13, y_3) / along_2;
    ray_0.t_min_0 = t_min_1;
    ray_0.t_max_0 = t_max_1;
    ray_0.local_per_t_0 = abs(along_2);
    ray_0.enter_0 = 0.0lf;
    ray_0.edge_on_0 = limit_at_0(u32(0));
    ray_0.largest_1 = limit_at_0(u32(1));
    return ray_0;
}

fn ray_child_0( node_6 : u32,  slot_2 : u32) -> u32
{
    return nodes_0[u32(14) * node_6 + u32(12) + slot_2 / u32(4)][slot_2 % u32(4)];
}

struct RayView_0
{
     inverse_1 : vec3<f32>,
     offset_near_0 : vec3<f32>,
     offset_far_0 : vec3<f32>,
     limit_0 : f32,
     margin_2 : f32,
     axes_4 : u32,
};

fn ray_bound_0( view_1 : RayView_0,  limit_1 : f32,  node_7 : u32,  slot_3 : u32) -> f32
{
    var _S325 : u32 = u32(14) * node_7 + slot_3 / u32(4);
    var near_4 : f32 = 0.0f;
    var far_3 : f32 = limit_1;
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
        var _S326 : u32 = axis_6;
        var _S327 : u32 = _S325 + u32(2) * axis_6;
        var _S328 : u32 = slot_3 % u32(4);
        var low_3 : f32 = (bitcast<f32>((nodes_0[_S327][_S328])));
        var high_0 : f32 = (bitcast<f32>((nodes_0[_S327 + u32(6)][_S328])));
        var _S329 : bool = (view_1.inverse_1[axis_6]) < 0.0f;
        var _S330 : f32;
        if(_S329)
        {
            _S330 = high_0;
        }
        else
        {
            _S330 = low_3;
        }
        var _S331 : f32 = max(near_4, _S330 * view_1.inverse_1[_S326] - view_1.offset_near_0[axis_6]);
        var _S332 : f32;
        if(_S329)
        {
            _S332 = low_3;
        }
        else
        {
            _S332 = high_0;
        }
        var _S333 : f32 = min(far_3, _S332 * view_1.inverse_1[_S326] - view_1.offset_far_0[axis_6]);
        var _S334 : u32 = axis_6 + u32(1);
        near_4 = _S331;
        far_3 = _S333;
        axis_6 = _S334;
    }
    if(near_4 <= far_3)
    {
    }
    else
    {
        near_4 = 3.00000000549775576e+38f;
    }
    return near_4;
}

fn nearest_first_0( bounds_0 : array<f32, i32(8)>,  limit_2 : f32) -> u32
{
    var k_8 : u32 = u32(0);
    var order_0 : u32 = u32(0);
    for(;;)
    {
        if(k_8 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S335 : u32 = k_8;
        if((bounds_0[k_8]) > limit_2)
        {
            k_8 = k_8 + u32(1);
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
            var _S336 : u32 = j_0;
            var _S337 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S335]))
            {
                _S337 = true;
            }
            else
            {
                if((bounds_0[_S336]) == (bounds_0[_S335]))
                {
                    _S337 = j_0 < k_8;
                }
                else
                {
                    _S337 = false;
                }
            }
            if(_S337)
            {
                rank_0 = rank_0 + u32(1);
            }
            j_0 = j_0 + u32(1);
        }
        order_0 = (order_0 | ((((k_8 + u32(1)) << ((u32(4) * rank_0))))));
        k_8 = k_8 + u32(1);
    }
    return order_0;
}

fn crossed_1( view_2 : RayView_0,  limit_3 : f32,  node_8 : u32) -> u32
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
        var _S338 : f32;
        if((ray_child_0(node_8, slot_4)) == u32(4294967295))
        {
            _S338 = 3.00000000549775576e+38f;
        }
        else
        {
            _S338 = ray_bound_0(view_2, limit_3, node_8, slot_4);
        }
        bounds_1[slot_4] = _S338;
        slot_4 = slot_4 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn rounded_0( product_2 : f64,  largest_2 : f64) -> f64
{
    return min(product_2, largest_2);
}

fn corner_2( ray_1 : Ray_0,  axes_5 : u32,  at_46 : u32) -> vec3<f64>
{
    var relative_1 : vec3<f64> = primitive_vector_0(at_46) - ray_1.origin_0;
    var z_4 : f64 = component_0(relative_1, (axes_5 >> (u32(4))));
    return vec3<f64>(component_0(relative_1, (axes_5 & (u32(3)))) - rounded_0(ray_1.shear_x_0 * z_4, ray_1.largest_1), component_0(relative_1, (((axes_5 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_1.shear_y_0 * z_4, ray_1.largest_1), z_4);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_8 : f64,
     v_9 : f64,
     w_3 : f64,
};

fn intersect_0( ray_2 : Ray_0,  axes_6 : u32,  at_47 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_8 = 0.0lf;
    crossing_0.v_9 = 0.0lf;
    crossing_0.w_3 = 0.0lf;
    var a_21 : vec3<f64> = corner_2(ray_2, axes_6, at_47);
    var b_14 : vec3<f64> = corner_2(ray_2, axes_6, at_47 + u32(3));
    var c_4 : vec3<f64> = corner_2(ray_2, axes_6, at_47 + u32(6));
    var _S339 : f64 = c_4.x;
    var _S340 : f64 = b_14.y;
    var cx_by_0 : f64 = rounded_0(_S339 * _S340, ray_2.largest_1);
    var _S341 : f64 = c_4.y;
    var _S342 : f64 = b_14.x;
    var cy_bx_0 : f64 = rounded_0(_S341 * _S342, ray_2.largest_1);
    var _S343 : f64 = a_21.x;
    var ax_cy_0 : f64 = rounded_0(_S343 * _S341, ray_2.largest_1);
    var _S344 : f64 = a_21.y;
    var ay_cx_0 : f64 = rounded_0(_S344 * _S339, ray_2.largest_1);
    var bx_ay_0 : f64 = rounded_0(_S342 * _S344, ray_2.largest_1);
    var by_ax_0 : f64 = rounded_0(_S340 * _S343, ray_2.largest_1);
    var u_2 : f64 = cx_by_0 - cy_bx_0;
    var v_10 : f64 = ax_cy_0 - ay_cx_0;
    var w_4 : f64 = bx_ay_0 - by_ax_0;
    var _S345 : f64 = min(min(u_2, v_10), w_4);
    var _S346 : f64 = max(max(u_2, v_10), w_4);
    var _S347 : bool;
    if(_S345 < 0.0lf)
    {
        _S347 = _S346 > 0.0lf;
    }
    else
    {
        _S347 = false;
    }
    if(_S347)
    {
        return crossing_0;
    }
    var determinant_0 : f64 = u_2 + v_10 + w_4;
    if(_S345 <= 0.0lf)
    {
        _S347 = _S346 >= 0.0lf;
    }
    else
    {
        _S347 = false;
    }
    if(_S347)
    {
        if((abs(determinant_0)) <= (ray_2.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0lf)
    {
        return crossing_0;
    }
    var t_9 : f64 = (rounded_0(u_2 * a_21.z, ray_2.largest_1) + rounded_0(v_10 * b_14.z, ray_2.largest_1) + rounded_0(w_4 * c_4.z, ray_2.largest_1)) / determinant_0 * ray_2.inverse_z_0;
    if((ray_2.t_min_0) <= t_9)
    {
        _S347 = t_9 <= (ray_2.t_max_0);
    }
    else
    {
        _S347 = false;
    }
    crossing_0.is_hit_0 = _S347;
    crossing_0.t_8 = t_9;
    crossing_0.v_9 = v_10 / determinant_0;
    crossing_0.w_3 = w_4 / determinant_0;
    return crossing_0;
}

fn face_1( triangle_7 : u32) -> u32
{
    return rough_0[triangle_7 / u32(4)][triangle_7 % u32(4)];
}

struct Found_0
{
     face_2 : u32,
     triangle_8 : u32,
     v_11 : f64,
     w_5 : f64,
};

fn first_found_0( view_3 : RayView_0,  ray_3 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S348 : bool;
    var found_0 : Found_0;
    found_0.face_2 = u32(4294967295);
    found_0.triangle_8 = u32(4294967295);
    found_0.v_11 = 0.0lf;
    found_0.w_5 = 0.0lf;
    if(!((view_3.limit_0) >= 0.0f))
    {
        return found_0;
    }
    var way_1 : array<vec2<u32>, i32(40)>;
    way_1[i32(0)] = vec2<u32>(u32(0), u32(0));
    var entered_0 : u32 = u32(0);
    var limit_4 : f32 = view_3.limit_0;
    var is_new_0 : bool = true;
    var level_0 : u32 = u32(0);
    for(;;)
    {
        var entered_1 : u32;
        var is_new_1 : bool;
        if(entered_0 != u32(4294967295))
        {
            way_1[level_0] = vec2<u32>(entered_0, crossed_1(view_3, limit_4, entered_0));
            is_new_1 = true;
            entered_1 = u32(4294967295);
        }
        else
        {
            is_new_1 = is_new_0;
            entered_1 = entered_0;
        }
        var here_1 : vec2<u32> = way_1[level_0];
        var _S349 : u32 = way_1[level_0].y;
        if(_S349 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S350 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S350;
            continue;
        }
        var slot_5 : u32 = ((_S349 & (u32(15)))) - u32(1);
        way_1[level_0][i32(1)] = (_S349 >> (u32(4)));
        var _S351 : bool;
        if(!is_new_1)
        {
            _S351 = (ray_bound_0(view_3, limit_4, here_1.x, slot_5)) > limit_4;
        }
        else
        {
            _S351 = false;
        }
        if(_S351)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_1.x, slot_5);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S352 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S352;
            continue;
        }
        var leaf_2 : u32 = (child_0 & (u32(2147483647)));
        var _S353 : u32 = leaf_starts_0[leaf_2 + u32(1)];
        var _S354 : u32 = leaf_starts_0[leaf_2];
        var limit_5 : f32 = limit_4;
        var i_2 : u32 = _S354;
        for(;;)
        {
            if(i_2 < _S353)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_3), view_3.axes_4, u32(9) * i_2);
            if(!crossing_1.is_hit_0)
            {
                i_2 = i_2 + u32(1);
                continue;
            }
            if((found_0.face_2) == u32(4294967295))
            {
                _S348 = true;
            }
            else
            {
                _S348 = (crossing_1.t_8) < ((*ray_3).t_max_0);
            }
            var _S355 : bool;
            if(_S348)
            {
                _S355 = true;
            }
            else
            {
                _S355 = (face_1(i_2)) < (found_0.face_2);
            }
            var limit_6 : f32;
            if(_S355)
            {
                found_0.face_2 = face_1(i_2);
                found_0.triangle_8 = i_2;
                (*ray_3).t_max_0 = crossing_1.t_8;
                found_0.v_11 = crossing_1.v_9;
                found_0.w_5 = crossing_1.w_3;
                limit_6 = min(limit_5, f32(crossing_1.t_8 * (*ray_3).local_per_t_0 - (*ray_3).enter_0) + 2.0f * view_3.margin_2);
            }
            else
            {
                limit_6 = limit_5;
            }
            limit_5 = limit_6;
            i_2 = i_2 + u32(1);
        }
        if(any_0)
        {
            _S348 = (found_0.face_2) != u32(4294967295);
        }
        else
        {
            _S348 = false;
        }
        if(_S348)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_0;
}

fn cast_0( origin_2 : vec3<f64>,  direction_14 : vec3<f64>,  t_min_2 : f64,  t_max_2 : f64,  any_1 : bool,  t_10 : ptr<function, f32>) -> Found_0
{
    var view_4 : RayView_0;
    var _S356 : u32 = view_4.axes_4;
    var _S357 : Ray_0 = ray_along_0(origin_2, direction_14, t_min_2, t_max_2, &(_S356));
    view_4.axes_4 = _S356;
    var ray_4 : Ray_0 = _S357;
    var _S358 : vec3<f32> = vec3<f32>(direction_14 / vec3<f64>(ray_4.local_per_t_0));
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
        var _S359 : f32 = max(abs(_S358[axis_7]), 8.67361737988403547e-19f);
        var _S360 : f32;
        if((_S358[axis_7]) < 0.0f)
        {
            _S360 = -1.0f / _S359;
        }
        else
        {
            _S360 = 1.0f / _S359;
        }
        view_4.inverse_1[axis_7] = _S360;
        axis_7 = axis_7 + u32(1);
    }
    var offset_11 : vec3<f32> = vec3<f32>(origin_2) * view_4.inverse_1;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_4.inverse_1);
    view_4.offset_near_0 = offset_11 + wider_0;
    view_4.offset_far_0 = offset_11 - wider_0;
    view_4.limit_0 = min(f32(t_max_2 * ray_4.local_per_t_0), 8.0f) + 3.814697265625e-06f;
    view_4.margin_2 = 3.814697265625e-06f;
    var found_1 : Found_0 = first_found_0(view_4, &(ray_4), any_1);
    (*t_10) = f32(ray_4.t_max_0);
    return found_1;
}

struct Side_0
{
     direction_15 : vec3<f32>,
     rest_3 : vec3<f32>,
     scattered_2 : vec3<f32>,
     found_2 : Found_0,
     t_11 : f32,
};

fn look_0( at_48 : ShadingPoint_0,  point_4 : EdgePoint_0,  side_1 : u32) -> Side_0
{
    var step_0 : vec3<f64> = point_4.normal_7 * vec3<f64>(edge_real_0(u32(3)));
    var origin_3 : vec3<f64>;
    if(side_1 == u32(0))
    {
        origin_3 = point_4.direction_12 - step_0;
    }
    else
    {
        origin_3 = point_4.direction_12 + step_0;
    }
    var direction_16 : vec3<f64> = exact_unit_0(origin_3);
    if(point_4.is_in_horizon_0)
    {
        var face_3 : vec3<f64> = face_normal_1(at_48);
        var height_3 : f64 = limit_at_0(u32(2));
        var _S361 : f64;
        if((dot(direction_16, face_3)) < 0.0lf)
        {
            _S361 = - height_3;
        }
        else
        {
            _S361 = height_3;
        }
        origin_3 = at_48.vertex_3.surface_4.exact_0 + face_3 * vec3<f64>(_S361);
    }
    else
    {
        origin_3 = at_48.vertex_3.surface_4.exact_0;
    }
    var seen_4 : Side_0;
    var _S362 : vec3<f32> = vec3<f32>(direction_16);
    seen_4.direction_15 = _S362;
    seen_4.rest_3 = vec3<f32>(direction_16 - vec3<f64>(_S362));
    seen_4.scattered_2 = scattered_from_0(at_48.vertex_3, _S362);
    var _S363 : f64 = limit_at_0(u32(2));
    var _S364 : f64 = limit_at_0(u32(1));
    var _S365 : f32 = seen_4.t_11;
    var _S366 : Found_0 = cast_0(origin_3, direction_16, _S363, _S364, false, &(_S365));
    seen_4.t_11 = _S365;
    seen_4.found_2 = _S366;
    return seen_4;
}

fn set_vector_0( path_9 : u32,  which_7 : ptr<function, u32>,  value_11 : vec3<f32>)
{
    var axis_8 : u32 = u32(0);
    for(;;)
    {
        if(axis_8 < u32(3))
        {
        }
        else
        {
            break;
        }
        set_word_0(path_9, (*which_7) + axis_8, (bitcast<u32>((value_11[axis_8]))));
        axis_8 = axis_8 + u32(1);
    }
    (*which_7) = (*which_7) + u32(3);
    return;
}

fn place_of_0( found_3 : Found_0) -> Place_0
{
    return exact_place_0(found_3.triangle_8, found_3.v_11, found_3.w_5);
}

fn emitter_seen_0( found_4 : Found_0,  direction_17 : vec3<f32>) -> u32
{
    if((found_4.face_2) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_5 : u32 = word_0(shape_of_0(found_4.triangle_8) + u32(4));
    var _S367 : bool;
    if(emitter_5 != u32(4294967295))
    {
        _S367 = (dot(cross_of_0(found_4.triangle_8), direction_17)) < 0.0f;
    }
    else
    {
        _S367 = false;
    }
    var _S368 : u32;
    if(_S367)
    {
        _S368 = emitter_5;
    }
    else
    {
        _S368 = u32(4294967295);
    }
    return _S368;
}

fn jump_of_light_0( at_49 : ShadingPoint_0,  point_5 : EdgePoint_0) -> vec3<f32>
{
    var _S369 : vec3<f32> = vec3<f32>(0.0f);
    var side_2 : u32 = u32(0);
    var jump_0 : vec3<f32> = _S369;
    for(;;)
    {
        if(side_2 < u32(2))
        {
        }
        else
        {
            break;
        }
        var seen_5 : Side_0 = look_0(at_49, point_5, side_2);
        var _S370 : bool;
        if(!((largest_0(seen_5.scattered_2)) > 0.0f))
        {
            _S370 = true;
        }
        else
        {
            _S370 = (emitter_seen_0(seen_5.found_2, seen_5.direction_15)) != (at_49.emitter_0);
        }
        if(_S370)
        {
            side_2 = side_2 + u32(1);
            continue;
        }
        var _S371 : Vector_0 = emitted_0(at_49.emitter_0, place_of_0(seen_5.found_2), still_0(seen_5.direction_15));
        var light_3 : vec3<f32> = seen_5.scattered_2 * value_of_0(_S371);
        var _S372 : vec3<f32>;
        if(side_2 == u32(0))
        {
            _S372 = light_3;
        }
        else
        {
            _S372 = (vec3<f32>(0) - light_3);
        }
        jump_0 = jump_0 + _S372;
        side_2 = side_2 + u32(1);
    }
    return jump_0;
}

fn cross_at_0( crossed_2 : ptr<function, Crossed_0>,  at_50 : ShadingPoint_0,  point_6 : EdgePoint_0,  number_of_path_3 : u32,  path_10 : Path_0)
{
    var flow_0 : f32 = flow_at_0(at_50, point_6);
    if(flow_0 == 0.0f)
    {
        return;
    }
    var _S373 : vec3<f32> = jump_of_light_0(at_50, point_6);
    (*crossed_2).term_0 = (*crossed_2).term_0 + (*crossed_2).factor_1 * _S373 * vec3<f32>(flow_0);
    return;
}

fn draw_points_0( at_51 : ShadingPoint_0,  node_9 : u32,  probability_4 : f32,  place_19 : f64,  number_of_path_4 : u32,  path_11 : Path_0,  crossed_3 : ptr<function, Crossed_0>)
{
    var _S374 : bool;
    var in_parts_0 : bool = (at_51.purpose_0) == u32(0);
    var most_0 : u32 = edge_word_0(u32(9));
    var part_2 : u32 = part_of_launch_0();
    var left_2 : u32 = side_path_0(number_of_path_4, u32(0));
    var leaves_2 : Leaves_0 = below_0(at_51, node_9);
    var _S375 : bool;
    if(in_parts_0)
    {
        _S375 = part_2 > u32(0);
    }
    else
    {
        _S375 = false;
    }
    var count_4 : u32;
    if(_S375)
    {
        var count_5 : u32 = path_word_0(left_2, u32(20));
        if(count_5 <= (most_0 * part_2))
        {
            return;
        }
        leaves_2.node_4 = path_word_0(left_2, u32(21));
        count_4 = count_5;
    }
    else
    {
        count_4 = u32(0);
    }
    if(in_parts_0)
    {
        _S375 = part_2 == u32(0);
    }
    else
    {
        _S375 = false;
    }
    var points_0 : u32 = u32(1);
    var least_3 : f32 = 0.0f;
    var over_all_0 : f32 = 0.0f;
    var total_0 : f32 = 0.0f;
    var step_1 : f64 = 0.0lf;
    var pass_0 : u32 = u32(0);
    var angles_0 : f32 = 0.0f;
    var contributions_0 : f32 = 0.0f;
    var pieces_1 : f32 = 0.0f;
    var drawn_0 : u32 = u32(0);
    var cumulative_0 : f32 = 0.0f;
    var target_0 : f64 = 0.0lf;
    for(;;)
    {
        if(pass_0 < u32(2))
        {
        }
        else
        {
            break;
        }
        var contributions_1 : f32;
        var target_1 : f64;
        if(pass_0 == u32(1))
        {
            if(!(angles_0 > 0.0f))
            {
                break;
            }
            var least_4 : f32 = 0.02999999932944775f * contributions_0 / angles_0 + 9.99999968265522539e-21f;
            var total_1 : f32 = contributions_0 + least_4 * angles_0;
            if(in_parts_0)
            {
                var parts_0 : f32 = ceil(f32(count_4) / f32(most_0));
                contributions_1 = min(4.0f * max(sqrt(pieces_1 / parts_0), 2.0f / parts_0), f32(edge_word_0(u32(10))));
            }
            else
            {
                contributions_1 = 1.0f;
            }
            var points_1 : u32 = u32(ceil(contributions_1 - 0.00100000004749745f));
            var _S376 : f32 = probability_4 * f32(points_1);
            var step_2 : f64 = f64(total_1) / f64(points_1);
            var _S377 : f64 = step_2 * place_19;
            points_0 = points_1;
            least_3 = least_4;
            over_all_0 = _S376;
            total_0 = total_1;
            step_1 = step_2;
            target_1 = _S377;
        }
        else
        {
            target_1 = target_0;
        }
        var rest_4 : Leaves_0 = leaves_2;
        var leaf_3 : u32;
        var drawn_1 : u32 = drawn_0;
        var passed_0 : u32 = u32(0);
        contributions_1 = contributions_0;
        var angles_1 : f32 = angles_0;
        var pieces_2 : f32 = pieces_1;
        var cumulative_1 : f32 = cumulative_0;
        var target_2 : f64 = target_1;
        for(;;)
        {
            var _S378 : bool;
            if(drawn_1 < points_0)
            {
                if(passed_0 < most_0)
                {
                    _S378 = true;
                }
                else
                {
                    if(_S375)
                    {
                        _S378 = pass_0 == u32(0);
                    }
                    else
                    {
                        _S378 = false;
                    }
                }
            }
            else
            {
                _S378 = false;
            }
            var _S379 : bool;
            if(_S378)
            {
                var _S380 : bool = next_leaf_0(at_51, &(rest_4), &(leaf_3));
                _S379 = _S380;
            }
            else
            {
                _S379 = false;
            }
            if(_S379)
            {
            }
            else
            {
                break;
            }
            var passed_1 : u32 = passed_0 + u32(1);
            if(passed_1 > most_0)
            {
                passed_0 = passed_1;
                continue;
            }
            if(in_parts_0)
            {
                _S374 = passed_1 == most_0;
            }
            else
            {
                _S374 = false;
            }
            if(_S374)
            {
                set_word_0(left_2, u32(21), rest_4.node_4);
            }
            var k_9 : u32 = edge_word_0(leaf_3 + u32(2));
            var drawn_2 : u32 = drawn_1;
            var contributions_2 : f32 = contributions_1;
            var angles_2 : f32 = angles_1;
            var pieces_3 : f32 = pieces_2;
            var cumulative_2 : f32 = cumulative_1;
            var target_3 : f64 = target_2;
            for(;;)
            {
                var _S381 : bool;
                if(k_9 < (edge_word_0(leaf_3 + u32(3))))
                {
                    _S381 = drawn_2 < points_0;
                }
                else
                {
                    _S381 = false;
                }
                if(_S381)
                {
                }
                else
                {
                    break;
                }
                var seen_6 : SeenEdge_0;
                var _S382 : bool = see_edge_0(at_51, k_9, &(seen_6));
                var drawn_3 : u32;
                var contributions_3 : f32;
                var angles_3 : f32;
                var pieces_4 : f32;
                var cumulative_3 : f32;
                var target_4 : f64;
                if(!_S382)
                {
                    drawn_3 = drawn_2;
                    contributions_3 = contributions_2;
                    angles_3 = angles_2;
                    pieces_4 = pieces_3;
                    cumulative_3 = cumulative_2;
                    target_4 = target_3;
                    k_9 = k_9 + u32(1);
                    drawn_2 = drawn_3;
                    contributions_2 = contributions_3;
                    angles_2 = angles_3;
                    pieces_3 = pieces_4;
                    cumulative_2 = cumulative_3;
                    target_3 = target_4;
                    continue;
                }
                var piece_2 : f32 = 0.0f;
                contributions_3 = contributions_2;
                angles_3 = angles_2;
                pieces_4 = pieces_3;
                cumulative_3 = cumulative_2;
                drawn_3 = drawn_2;
                target_4 = target_3;
                for(;;)
                {
                    if(piece_2 < (seen_6.pieces_0))
                    {
                    }
                    else
                    {
                        break;
                    }
                    var weight_0 : vec2<f32> = weigh_0(at_51, seen_6, piece_2);
                    if(pass_0 == u32(0))
                    {
                        var angles_4 : f32 = angles_3 + weight_0.y;
                        var pieces_5 : f32 = pieces_4 + 1.0f;
                        contributions_3 = contributions_3 + weight_0.x;
                        angles_3 = angles_4;
                        pieces_4 = pieces_5;
                        piece_2 = piece_2 + 1.0f;
                        continue;
                    }
                    var own_1 : f32 = weight_0.x + least_3 * weight_0.y;
                    var cumulative_4 : f32 = cumulative_3 + own_1;
                    var drawn_4 : u32 = drawn_3;
                    var target_5 : f64 = target_4;
                    for(;;)
                    {
                        var _S383 : bool;
                        if(drawn_4 < points_0)
                        {
                            _S383 = target_5 < f64(cumulative_4);
                        }
                        else
                        {
                            _S383 = false;
                        }
                        if(_S383)
                        {
                        }
                        else
                        {
                            break;
                        }
                        var _S384 : u32 = drawn_4 + u32(1);
                        var target_6 : f64 = target_5 + step_1;
                        cross_at_0(&((*crossed_3)), at_51, point_on_0(at_51, seen_6, piece_2, clamp((target_5 - f64(cumulative_3)) / f64(own_1), 0.0lf, 1.0lf), over_all_0 * own_1 / total_0), number_of_path_4, path_11);
                        drawn_4 = _S384;
                        target_5 = target_6;
                    }
                    cumulative_3 = cumulative_4;
                    drawn_3 = drawn_4;
                    target_4 = target_5;
                    piece_2 = piece_2 + 1.0f;
                }
                k_9 = k_9 + u32(1);
                drawn_2 = drawn_3;
                contributions_2 = contributions_3;
                angles_2 = angles_3;
                pieces_3 = pieces_4;
                cumulative_2 = cumulative_3;
                target_3 = target_4;
            }
            drawn_1 = drawn_2;
            passed_0 = passed_1;
            contributions_1 = contributions_2;
            angles_1 = angles_2;
            pieces_2 = pieces_3;
            cumulative_1 = cumulative_2;
            target_2 = target_3;
        }
        if(!_S375)
        {
            _S374 = true;
        }
        else
        {
            _S374 = pass_0 > u32(0);
        }
        if(_S374)
        {
            pass_0 = pass_0 + u32(1);
            angles_0 = angles_1;
            contributions_0 = contributions_1;
            pieces_1 = pieces_2;
            drawn_0 = drawn_1;
            cumulative_0 = cumulative_1;
            target_0 = target_2;
            continue;
        }
        if(passed_0 <= most_0)
        {
            count_4 = passed_0;
            pass_0 = pass_0 + u32(1);
            angles_0 = angles_1;
            contributions_0 = contributions_1;
            pieces_1 = pieces_2;
            drawn_0 = drawn_1;
            cumulative_0 = cumulative_1;
            target_0 = target_2;
            continue;
        }
        set_word_0(left_2, u32(20), passed_0);
        var _S385 : u32 = (passed_0 + most_0 - u32(1)) / most_0;
        var _S386 : u32 = atomicMax(&(sums_0[u32(3)]), _S385);
        count_4 = passed_0;
        pass_0 = pass_0 + u32(1);
        angles_0 = angles_1;
        contributions_0 = contributions_1;
        pieces_1 = pieces_2;
        drawn_0 = drawn_1;
        cumulative_0 = cumulative_1;
        target_0 = target_2;
    }
    return;
}

fn sample_points_0( at_52 : ShadingPoint_0,  number_of_path_5 : u32,  path_12 : Path_0,  crossed_4 : ptr<function, Crossed_0>)
{
    var numbers_8 : u32 = numbers_for_0(at_52.purpose_0) + u32(1);
    var part_3 : u32 = part_of_launch_0();
    var node_10 : u32 = node_at_0(at_52, u32(0));
    var probability_5 : f32 = 1.0f;
    if((at_52.purpose_0) != u32(0))
    {
        var subtrees_0 : u32;
        if((depth_of_launch_0()) == u32(0))
        {
            subtrees_0 = u32(2);
        }
        else
        {
            subtrees_0 = u32(1);
        }
        var u_3 : f64 = (f64(part_3) + precise_random_0(path_12.key_0, numbers_8)) / f64(subtrees_0);
        var _S387 : bool;
        if(part_3 >= subtrees_0)
        {
            _S387 = true;
        }
        else
        {
            var _S388 : bool = descend_0(at_52, u_3, &(node_10), &(probability_5));
            _S387 = !_S388;
        }
        if(_S387)
        {
            return;
        }
        probability_5 = probability_5 * f32(subtrees_0);
    }
    var place_20 : f64 = precise_random_0(path_12.key_0, numbers_8 + u32(1)) + f64(0.6180340051651001f * f32(part_3));
    draw_points_0(at_52, node_10, probability_5, place_20 - floor(place_20), number_of_path_5, path_12, &((*crossed_4)));
    return;
}

fn add_0( number_of_path_6 : u32,  crossed_5 : Crossed_0)
{
    var change_7 : u32 = u32(4);
    var before_2 : vec3<f32> = path_vector_0(number_of_path_6, &(change_7));
    change_7 = u32(4);
    set_vector_0(number_of_path_6, &(change_7), before_2 + crossed_5.term_0);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S389 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S390 : u32 = u32(2) + zero_0;
        _S389 = _S390;
        if(rounds_0 < _S390)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S389;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S391 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn cross_edges(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var listed_0 : u32 = launch_0.first_0 + thread_0.x;
    if(listed_0 >= (launch_0.end_0))
    {
        return;
    }
    var number_of_path_7 : u32 = input_0[listed_0];
    if((part_of_launch_0()) == u32(0))
    {
        set_word_0(side_path_0(number_of_path_7, u32(0)), u32(20), u32(0));
    }
    var factor_5 : vec3<f32>;
    var path_13 : Path_0 = path_at_vertex_0(number_of_path_7, &(factor_5));
    var at_53 : ShadingPoint_0;
    var _S392 : bool = shading_point_0(path_13, &(at_53));
    if(!_S392)
    {
        return;
    }
    var crossed_6 : Crossed_0 = nothing_crossed_0(factor_5);
    var purpose_3 : u32 = u32(0);
    for(;;)
    {
        if(purpose_3 <= u32(1))
        {
        }
        else
        {
            break;
        }
        var probability_6 : f32 = turn_to_0(purpose_3, path_13.key_0, &(at_53));
        if(!(probability_6 > 0.0f))
        {
            purpose_3 = purpose_3 + u32(1);
            continue;
        }
        crossed_6.factor_1 = factor_5 / vec3<f32>(probability_6);
        sample_points_0(at_53, number_of_path_7, path_13, &(crossed_6));
        purpose_3 = purpose_3 + u32(1);
    }
    add_0(number_of_path_7, crossed_6);
    check_loops_0();
    return;
}
