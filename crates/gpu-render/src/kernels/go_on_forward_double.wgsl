// Compiled from forward.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: abe3870cd5efa04f
// result: 09c696e5c1acad08

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

fn _d_dot_0( dpx_4 : DiffPair_vectorx3Cfloatx2C2x3E_0,  dpy_0 : DiffPair_vectorx3Cfloatx2C2x3E_0) -> DiffPair_float_0
{
    var _S22 : DiffPair_float_0 = DiffPair_float_0( dpx_4.primal_0[i32(0)] * dpy_0.primal_0[i32(0)] + dpx_4.primal_0[i32(1)] * dpy_0.primal_0[i32(1)], dpx_4.primal_0[i32(0)] * dpy_0.differential_0[i32(0)] + dpy_0.primal_0[i32(0)] * dpx_4.differential_0[i32(0)] + dpx_4.primal_0[i32(1)] * dpy_0.differential_0[i32(1)] + dpy_0.primal_0[i32(1)] * dpx_4.differential_0[i32(1)] );
    return _S22;
}

fn _d_max_0( dpx_5 : DiffPair_float_0,  dpy_1 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S23 : f32 = max(dpx_5.primal_0, dpy_1.primal_0);
    var _S24 : f32;
    if((dpx_5.primal_0) > (dpy_1.primal_0))
    {
        _S24 = dpx_5.differential_0;
    }
    else
    {
        if((dpx_5.primal_0) < (dpy_1.primal_0))
        {
            _S24 = dpy_1.differential_0;
        }
        else
        {
            _S24 = 0.5f * (dpx_5.differential_0 + dpy_1.differential_0);
        }
    }
    var _S25 : DiffPair_float_0 = DiffPair_float_0( _S23, _S24 );
    return _S25;
}

fn _d_max_vector_0( dpx_6 : DiffPair_vectorx3Cfloatx2C2x3E_0,  dpy_2 : DiffPair_vectorx3Cfloatx2C2x3E_0) -> DiffPair_vectorx3Cfloatx2C2x3E_0
{
    var _S26 : DiffPair_float_0 = DiffPair_float_0( dpx_6.primal_0[i32(0)], dpx_6.differential_0[i32(0)] );
    var _S27 : DiffPair_float_0 = DiffPair_float_0( dpy_2.primal_0[i32(0)], dpy_2.differential_0[i32(0)] );
    var dp_elem_0 : DiffPair_float_0 = _d_max_0(_S26, _S27);
    var result_0 : vec2<f32>;
    result_0[i32(0)] = dp_elem_0.primal_0;
    var d_result_0 : vec2<f32>;
    d_result_0[i32(0)] = dp_elem_0.differential_0;
    var _S28 : DiffPair_float_0 = DiffPair_float_0( dpx_6.primal_0[i32(1)], dpx_6.differential_0[i32(1)] );
    var _S29 : DiffPair_float_0 = DiffPair_float_0( dpy_2.primal_0[i32(1)], dpy_2.differential_0[i32(1)] );
    var dp_elem_1 : DiffPair_float_0 = _d_max_0(_S28, _S29);
    result_0[i32(1)] = dp_elem_1.primal_0;
    d_result_0[i32(1)] = dp_elem_1.differential_0;
    var _S30 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( result_0, d_result_0 );
    return _S30;
}

fn _d_min_0( dpx_7 : DiffPair_float_0,  dpy_3 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S31 : f32 = min(dpx_7.primal_0, dpy_3.primal_0);
    var _S32 : f32;
    if((dpx_7.primal_0) < (dpy_3.primal_0))
    {
        _S32 = dpx_7.differential_0;
    }
    else
    {
        if((dpx_7.primal_0) > (dpy_3.primal_0))
        {
            _S32 = dpy_3.differential_0;
        }
        else
        {
            _S32 = 0.5f * (dpx_7.differential_0 + dpy_3.differential_0);
        }
    }
    var _S33 : DiffPair_float_0 = DiffPair_float_0( _S31, _S32 );
    return _S33;
}

fn _d_dot_1( dpx_8 : DiffPair_vectorx3Cfloatx2C3x3E_0,  dpy_4 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_float_0
{
    var _S34 : DiffPair_float_0 = DiffPair_float_0( dpx_8.primal_0[i32(0)] * dpy_4.primal_0[i32(0)] + dpx_8.primal_0[i32(1)] * dpy_4.primal_0[i32(1)] + dpx_8.primal_0[i32(2)] * dpy_4.primal_0[i32(2)], dpx_8.primal_0[i32(0)] * dpy_4.differential_0[i32(0)] + dpy_4.primal_0[i32(0)] * dpx_8.differential_0[i32(0)] + dpx_8.primal_0[i32(1)] * dpy_4.differential_0[i32(1)] + dpy_4.primal_0[i32(1)] * dpx_8.differential_0[i32(1)] + dpx_8.primal_0[i32(2)] * dpy_4.differential_0[i32(2)] + dpy_4.primal_0[i32(2)] * dpx_8.differential_0[i32(2)] );
    return _S34;
}

fn _d_abs_0( dpx_9 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S35 : DiffPair_float_0 = DiffPair_float_0( abs(dpx_9.primal_0), select(select(-1.0f, 0.0f, (dpx_9.primal_0) == 0.0f), 1.0f, (dpx_9.primal_0) > 0.0f) * dpx_9.differential_0 );
    return _S35;
}

fn _d_cross_0( a_0 : DiffPair_vectorx3Cfloatx2C3x3E_0,  b_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S36 : f32 = a_0.primal_0.y;
    var _S37 : f32 = b_0.primal_0.z;
    var _S38 : f32 = a_0.primal_0.z;
    var _S39 : f32 = b_0.primal_0.y;
    var _S40 : f32 = a_0.differential_0.y;
    var _S41 : f32 = b_0.differential_0.z;
    var _S42 : f32 = a_0.differential_0.z;
    var _S43 : f32 = b_0.differential_0.y;
    var _S44 : f32 = b_0.primal_0.x;
    var _S45 : f32 = a_0.primal_0.x;
    var _S46 : f32 = b_0.differential_0.x;
    var _S47 : f32 = a_0.differential_0.x;
    var _S48 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( vec3<f32>(_S36 * _S37 - _S38 * _S39, _S38 * _S44 - _S45 * _S37, _S45 * _S39 - _S36 * _S44), vec3<f32>(_S40 * _S37 + _S36 * _S41 - _S42 * _S39 - _S38 * _S43, _S42 * _S44 + _S38 * _S46 - _S47 * _S37 - _S45 * _S41, _S47 * _S39 + _S45 * _S43 - _S40 * _S44 - _S36 * _S46) );
    return _S48;
}

fn path_word_0( path_0 : u32,  which_0 : u32) -> u32
{
    return paths_0[which_0 * launch_0.room_0 + path_0];
}

fn path_vector_0( path_1 : u32,  which_1 : ptr<function, u32>) -> vec3<f32>
{
    var _S49 : u32 = (*which_1) + u32(3);
    (*which_1) = _S49;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_1, _S49 - u32(3)), path_word_0(path_1, _S49 - u32(2)), path_word_0(path_1, _S49 - u32(1))))));
}

fn path_vector_1( path_2 : u32,  which_2 : ptr<function, u32>) -> vec3<f32>
{
    var _S50 : u32 = (*which_2) + u32(3);
    (*which_2) = _S50;
    return (bitcast<vec3<f32>>((vec3<u32>(path_word_0(path_2, _S50 - u32(3)), path_word_0(path_2, _S50 - u32(2)), path_word_0(path_2, _S50 - u32(1))))));
}

struct Vector_0
{
     value_0 : vec3<f32>,
     change_0 : vec3<f32>,
};

fn changing_0( value_1 : vec3<f32>,  change_1 : vec3<f32>) -> Vector_0
{
    var vector_0 : Vector_0;
    vector_0.value_0 = value_1;
    vector_0.change_0 = change_1;
    return vector_0;
}

fn path_changing_0( path_3 : u32,  which_3 : ptr<function, u32>) -> Vector_0
{
    var value_2 : vec3<f32> = path_vector_1(path_3, &((*which_3)));
    var _S51 : vec3<f32> = path_vector_1(path_3, &((*which_3)));
    return changing_0(value_2, _S51);
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
    var _S52 : f32 = f32(v_1);
    place_0.v_0 = _S52;
    var _S53 : f32 = f32(w_1);
    place_0.w_0 = _S53;
    place_0.v_rest_0 = f32(v_1 - f64(_S52));
    place_0.w_rest_0 = f32(w_1 - f64(_S53));
    place_0.change_2 = vec2<f32>(0.0f);
    return place_0;
}

fn path_place_0( path_4 : u32,  which_4 : ptr<function, u32>) -> Place_0
{
    var _S54 : u32 = (*which_4) + u32(5);
    (*which_4) = _S54;
    return exact_place_0(path_word_0(path_4, _S54 - u32(5)), f64((bitcast<f32>((path_word_0(path_4, _S54 - u32(4)))))) + f64((bitcast<f32>((path_word_0(path_4, _S54 - u32(2)))))), f64((bitcast<f32>((path_word_0(path_4, _S54 - u32(3)))))) + f64((bitcast<f32>((path_word_0(path_4, _S54 - u32(1)))))));
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

fn load_0( number_of_path_0 : u32) -> Path_0
{
    var at_1 : u32 = u32(1);
    var path_5 : Path_0;
    var _S55 : Vector_0 = path_changing_0(number_of_path_0, &(at_1));
    path_5.light_0 = _S55;
    var _S56 : Vector_0 = path_changing_0(number_of_path_0, &(at_1));
    path_5.throughput_0 = _S56;
    var _S57 : Vector_0 = path_changing_0(number_of_path_0, &(at_1));
    path_5.direction_0 = _S57;
    var _S58 : vec3<f32> = path_vector_0(number_of_path_0, &(at_1));
    path_5.drift_0 = _S58;
    var _S59 : Place_0 = path_place_0(number_of_path_0, &(at_1));
    path_5.place_1 = _S59;
    path_5.key_0 = vec2<u32>(path_word_0(number_of_path_0, at_1), path_word_0(number_of_path_0, at_1 + u32(1)));
    path_5.walked_0 = vec3<f32>(0.0f);
    path_5.divergence_0 = 0.0f;
    if(walks_0())
    {
        at_1 = u32(29);
        var _S60 : vec3<f32> = path_vector_0(number_of_path_0, &(at_1));
        path_5.walked_0 = _S60;
        path_5.divergence_0 = (bitcast<f32>((path_word_0(number_of_path_0, at_1))));
    }
    return path_5;
}

fn still_0( value_3 : vec3<f32>) -> Vector_0
{
    return changing_0(value_3, vec3<f32>(0.0f));
}

struct Reflected_0
{
     direct_0 : Vector_0,
     onward_0 : Vector_0,
};

fn nothing_reflected_0() -> Reflected_0
{
    var reflected_0 : Reflected_0;
    var _S61 : Vector_0 = still_0(vec3<f32>(0.0f));
    reflected_0.direct_0 = _S61;
    reflected_0.onward_0 = _S61;
    return reflected_0;
}

fn word_0( at_2 : u32) -> u32
{
    return scene_0[at_2];
}

fn vertex_numbers_0( depth_1 : u32) -> u32
{
    return word_0(u32(7)) + depth_1 * (u32(3) * word_0(u32(2)) + u32(3) * word_0(u32(3)) + u32(1));
}

fn value_of_0( vector_1 : Vector_0) -> vec3<f32>
{
    return vector_1.value_0;
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
    var _S62 : vec3<f64> = position_of_0(place_4);
    surface_0.exact_0 = _S62;
    surface_0.position_0 = vec3<f32>(_S62);
    var _S63 : vec3<f32> = unit_0(cross_of_0(place_4.triangle_0));
    surface_0.face_normal_0 = _S63;
    surface_0.outward_0 = _S63;
    var seen_0 : f32;
    if((dot(_S63, direction_1)) > 0.0f)
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
    var _S64 : vec3<f32> = vec3<f32>(0.0f);
    surface_0.outward_change_0 = _S64;
    surface_0.position_change_0 = _S64;
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
    var _S65 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_0 + u32(3)) - a_5);
    var _S66 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_0 + u32(6)) - a_5);
    var across_0 : vec3<f32> = cross(_S65, _S66);
    var _S67 : f32 = max(max(abs(across_0.x), abs(across_0.y)), abs(across_0.z));
    var normal_0 : vec3<f32> = across_0 / vec3<f32>(_S67);
    var slip_0 : vec3<f32> = drift_1 - of_material_0;
    var slip_1 : vec3<f32> = slip_0 - direction_2 * vec3<f32>((dot(normal_0, slip_0) / dot(normal_0, direction_2)));
    (*position_change_1) = of_material_0 + slip_1;
    (*place_6).change_2 = vec2<f32>(dot(slip_1, cross(_S66, normal_0)), dot(slip_1, cross(normal_0, _S65))) * vec2<f32>((1.0f / (dot(normal_0, normal_0) * _S67)));
    return;
}

fn move_place_1( place_7 : ptr<function, Place_0>,  position_change_2 : ptr<function, vec3<f32>>,  direction_3 : vec3<f32>,  drift_2 : vec3<f32>)
{
    (*position_change_2) = drift_2;
    if(!is_moving_0())
    {
        return;
    }
    var at_10 : u32 = motion_of_0((*place_7).triangle_0);
    var corner_1 : u32 = u32(9) * (*place_7).triangle_0;
    var of_material_1 : vec3<f32> = at_place_0(change_vector_0(at_10), change_vector_0(at_10 + u32(3)), change_vector_0(at_10 + u32(6)), (*place_7));
    var a_6 : vec3<f64> = primitive_vector_0(corner_1);
    var _S68 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_1 + u32(3)) - a_6);
    var _S69 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_1 + u32(6)) - a_6);
    var across_1 : vec3<f32> = cross(_S68, _S69);
    var _S70 : f32 = max(max(abs(across_1.x), abs(across_1.y)), abs(across_1.z));
    var normal_1 : vec3<f32> = across_1 / vec3<f32>(_S70);
    var slip_2 : vec3<f32> = drift_2 - of_material_1;
    var slip_3 : vec3<f32> = slip_2 - direction_3 * vec3<f32>((dot(normal_1, slip_2) / dot(normal_1, direction_3)));
    (*position_change_2) = of_material_1 + slip_3;
    (*place_7).change_2 = vec2<f32>(dot(slip_3, cross(_S69, normal_1)), dot(slip_3, cross(normal_1, _S68))) * vec2<f32>((1.0f / (dot(normal_1, normal_1) * _S70)));
    return;
}

fn change_of_unit_0( vector_2 : vec3<f32>,  change_3 : vec3<f32>,  size_0 : f32) -> vec3<f32>
{
    return (change_3 - vector_2 * vec3<f32>(dot(vector_2, change_3))) / vec3<f32>(size_0);
}

fn move_surface_0( surface_1 : ptr<function, Surface_0>,  direction_4 : vec3<f32>,  drift_3 : vec3<f32>)
{
    var _S71 : Place_0 = (*surface_1).place_3;
    var _S72 : vec3<f32> = (*surface_1).position_change_0;
    move_place_1(&(_S71), &(_S72), direction_4, drift_3);
    (*surface_1).place_3 = _S71;
    (*surface_1).position_change_0 = _S72;
    if(!is_moving_0())
    {
        return;
    }
    var place_8 : Place_0 = (*surface_1).place_3;
    var at_11 : u32 = motion_of_0((*surface_1).place_3.triangle_0);
    var normals_1 : u32 = word_0((*surface_1).shape_0);
    if(normals_1 == u32(4294967295))
    {
        var corner_2 : u32 = u32(9) * place_8.triangle_0;
        var a_7 : vec3<f64> = primitive_vector_0(corner_2);
        var _S73 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_2 + u32(3)) - a_7);
        var _S74 : vec3<f32> = vec3<f32>(primitive_vector_0(corner_2 + u32(6)) - a_7);
        var a_change_0 : vec3<f32> = change_vector_0(at_11);
        (*surface_1).outward_change_0 = change_of_unit_0((*surface_1).outward_0, cross(change_vector_0(at_11 + u32(3)) - a_change_0, _S74) + cross(_S73, change_vector_0(at_11 + u32(6)) - a_change_0), length(cross(_S73, _S74)));
        return;
    }
    var record_1 : u32 = triangle_record_0(place_8.triangle_0) + u32(2);
    var a_8 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_1));
    var ab_0 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_1 + u32(1))) - a_8;
    var ac_0 : vec3<f32> = vector_at_0(normals_1 + u32(3) * word_0(record_1 + u32(2))) - a_8;
    var at_12 : u32 = at_11 + u32(9);
    (*surface_1).outward_change_0 = change_of_unit_0((*surface_1).outward_0, at_place_0(change_vector_0(at_12), change_vector_0(at_12 + u32(3)), change_vector_0(at_12 + u32(6)), place_8) + (ab_0 * vec3<f32>(place_8.change_2.x) + ac_0 * vec3<f32>(place_8.change_2.y)), length(a_8 + ab_0 * vec3<f32>(place_8.v_0) + ac_0 * vec3<f32>(place_8.w_0)));
    return;
}

fn material_of_0( surface_2 : Surface_0) -> u32
{
    var _S75 : u32;
    if(surface_2.is_front_0)
    {
        _S75 = u32(2);
    }
    else
    {
        _S75 = u32(3);
    }
    return word_0(surface_2.shape_0 + _S75);
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
    var _S76 : vec3<f32> = vec3<f32>(0.0f);
    numbers_0.k_0 = _S76;
    numbers_0.eta_0 = _S76;
    numbers_0.specular_reflectance_0 = _S76;
    numbers_0.diffuse_reflectance_0 = _S76;
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
    var _S77 : vec4<f32> = vec4<f32>(0.0f);
    lookup_0.by_second_0 = _S77;
    lookup_0.by_first_0 = _S77;
    return lookup_0;
}

struct Corners2_0
{
     a_9 : vec2<f64>,
     b_3 : vec2<f64>,
     c_2 : vec2<f64>,
};

fn Corners2_x24init_0( a_10 : vec2<f64>,  b_4 : vec2<f64>,  c_3 : vec2<f64>) -> Corners2_0
{
    var _S78 : Corners2_0;
    _S78.a_9 = a_10;
    _S78.b_3 = b_4;
    _S78.c_2 = c_3;
    return _S78;
}

fn precise_0( at_13 : u32) -> f64
{
    return f64(number_0(at_13)) + f64(number_0(at_13 + u32(1)));
}

fn uvs_of_0( triangle_6 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f64>(0.0lf, 0.0lf), vec2<f64>(1.0lf, 0.0lf), vec2<f64>(0.0lf, 1.0lf));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_6) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_14 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_6) + u32(1));
    uvs_0.a_9 = vec2<f64>(precise_0(at_14), precise_0(at_14 + u32(2)));
    uvs_0.b_3 = vec2<f64>(precise_0(at_14 + u32(4)), precise_0(at_14 + u32(6)));
    uvs_0.c_2 = vec2<f64>(precise_0(at_14 + u32(8)), precise_0(at_14 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_15 : u32) -> vec3<f64>
{
    return vec3<f64>(precise_0(at_15), precise_0(at_15 + u32(2)), precise_0(at_15 + u32(4)));
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

fn between_0( texels_1 : vec4<u32>,  place_9 : Point_0) -> Lookup_0
{
    var _S79 : vec2<f32> = vec2<f32>(place_9.value_4 - floor(place_9.value_4));
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - _S79;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S80 : f32 = back_0.x;
    var _S81 : f32 = back_0.y;
    var _S82 : f32 = _S79.x;
    var _S83 : f32 = _S79.y;
    lookup_1.weights_0 = vec4<f32>(_S80 * _S81, _S82 * _S81, _S80 * _S83, _S82 * _S83);
    var by_x_0 : vec4<f32> = vec4<f32>(- _S81, _S81, - _S83, _S83);
    var by_y_0 : vec4<f32> = vec4<f32>(- _S80, - _S82, _S80, _S82);
    lookup_1.by_first_0 = by_x_0 * vec4<f32>(place_9.by_first_1.x) + by_y_0 * vec4<f32>(place_9.by_first_1.y);
    lookup_1.by_second_0 = by_x_0 * vec4<f32>(place_9.by_second_1.x) + by_y_0 * vec4<f32>(place_9.by_second_1.y);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_0 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var size_1 : vec2<f32> = vec2<f32>(f32(width_0), f32(height_0));
    var place_10 : vec2<f64> = uv_0.value_4 * vec2<f64>(size_1);
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_0 : u32 = wrapped_0(floor_of_0(place_10.y), height_0, wrap_1);
        var _S84 : u32 = row_0 * u32(width_0);
        var _S85 : u32 = wrapped_0(floor_of_0(place_10.x), width_0, wrap_1);
        return one_texel_0(_S84 + _S85);
    }
    var centred_0 : Point_0;
    var _S86 : vec2<f64> = place_10 - vec2<f64>(0.5lf);
    centred_0.value_4 = _S86;
    centred_0.by_first_1 = uv_0.by_first_1 * size_1;
    centred_0.by_second_1 = uv_0.by_second_1 * size_1;
    var x_1 : i32 = floor_of_0(_S86.x);
    var y_0 : i32 = floor_of_0(_S86.y);
    var _S87 : u32 = wrapped_0(y_0, height_0, wrap_1);
    var _S88 : u32 = u32(width_0);
    var first_1 : u32 = _S87 * _S88;
    var _S89 : u32 = wrapped_0(y_0 + i32(1), height_0, wrap_1);
    var second_0 : u32 = _S89 * _S88;
    var left_0 : u32 = wrapped_0(x_1, width_0, wrap_1);
    var right_0 : u32 = wrapped_0(x_1 + i32(1), width_0, wrap_1);
    return between_0(vec4<u32>(first_1 + left_0, first_1 + right_0, second_0 + left_0, second_0 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_11 : Place_0) -> Lookup_0
{
    var kind_0 : u32 = word_0(texture_1);
    if(kind_0 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_2 : u32 = triangle_record_0(place_11.triangle_0) + u32(1);
    if(kind_0 == u32(4))
    {
        return one_texel_0(word_0(record_2));
    }
    if(kind_0 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_2 + u32(1)), word_0(record_2 + u32(2)), word_0(record_2 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_11.v_0 - place_11.w_0, place_11.v_0, place_11.w_0, 0.0f);
        lookup_2.by_first_0 = vec4<f32>(-1.0f, 1.0f, 0.0f, 0.0f);
        lookup_2.by_second_0 = vec4<f32>(-1.0f, 0.0f, 1.0f, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_11.triangle_0);
    var by_v_0 : vec2<f64> = uvs_1.b_3 - uvs_1.a_9;
    var by_w_0 : vec2<f64> = uvs_1.c_2 - uvs_1.a_9;
    var _S90 : u32 = texture_1 + u32(6);
    var to_u_0 : vec3<f64> = row_at_0(_S90);
    var to_v_0 : vec3<f64> = row_at_0(_S90 + u32(6));
    var uv_1 : Point_0;
    var _S91 : vec3<f64> = vec3<f64>(uvs_1.a_9 + by_v_0 * vec2<f64>((f64(place_11.v_0) + f64(place_11.v_rest_0))) + by_w_0 * vec2<f64>((f64(place_11.w_0) + f64(place_11.w_rest_0))), 1.0lf);
    uv_1.value_4 = vec2<f64>(dot(_S91, to_u_0), dot(_S91, to_v_0));
    var _S92 : vec2<f64> = to_u_0.xy;
    var _S93 : vec2<f64> = to_v_0.xy;
    uv_1.by_first_1 = vec2<f32>(vec2<f64>(dot(by_v_0, _S92), dot(by_v_0, _S93)));
    uv_1.by_second_1 = vec2<f32>(vec2<f64>(dot(by_w_0, _S92), dot(by_w_0, _S93)));
    if(kind_0 == u32(1))
    {
        var _S94 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S94;
    }
    var half_of_period_0 : vec2<f64> = uv_1.value_4 - floor(uv_1.value_4);
    var _S95 : i32;
    if(((half_of_period_0.x) > 0.5lf) != ((half_of_period_0.y) > 0.5lf))
    {
        _S95 = i32(1);
    }
    else
    {
        _S95 = i32(0);
    }
    return one_texel_0(u32(_S95));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_1 : vec4<f32>) -> vec3<f32>
{
    var _S96 : u32 = word_0(texture_2 + u32(1));
    var _S97 : u32 = texture_2 + u32(19);
    var _S98 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_5 : vec3<f32> = _S98;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_16 : u32 = _S97 + _S96 * lookup_3.texels_0[k_1];
        var _S99 : vec3<f32>;
        if(_S96 == u32(1))
        {
            _S99 = vec3<f32>(number_0(at_16));
        }
        else
        {
            _S99 = vector_at_0(at_16);
        }
        var value_6 : vec3<f32> = value_5 + _S99 * vec3<f32>(weights_1[k_1]);
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
    var _S100 : bool = (word_0(texture_4 + u32(1))) == u32(1);
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
        var _S101 : i32;
        if(_S100)
        {
            _S101 = i32(1);
        }
        else
        {
            _S101 = i32(3);
        }
        var at_17 : u32 = first_2 + u32(_S101) * lookup_4.texels_0[k_2];
        var of_texel_0 : vec3<f32>;
        if(_S100)
        {
            of_texel_0 = (bitcast<vec3<f32>>((vec3<u32>(change_word_0(at_17)))));
        }
        else
        {
            of_texel_0 = change_vector_0(at_17);
        }
        var change_6 : vec3<f32> = change_5 + of_texel_0 * vec3<f32>(lookup_4.weights_0[k_2]);
        k_2 = k_2 + u32(1);
        change_5 = change_6;
    }
    return changing_0(value_7, change_5);
}

fn shown_0( texture_5 : u32,  place_12 : Place_0) -> Vector_0
{
    var _S102 : Lookup_0 = lookup_at_0(texture_5, place_12);
    return looked_up_0(texture_5, _S102, place_12.change_2);
}

fn luminance_0( colour_0 : vec3<f32>) -> f32
{
    return dot(colour_0, vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f));
}

fn s_fwd_luminance_0( dpcolour_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_float_0
{
    var _S103 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpcolour_0.primal_0, dpcolour_0.differential_0 );
    var _S104 : vec3<f32> = vec3<f32>(0.0f);
    var _S105 : vec3<f32> = vec3<f32>(0.21267099678516388f, 0.71516001224517822f, 0.07216899842023849f);
    var _S106 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( _S105, _S104 );
    var _S107 : DiffPair_float_0 = _d_dot_1(_S103, _S106);
    var _S108 : DiffPair_float_0 = DiffPair_float_0( _S107.primal_0, _S107.differential_0 );
    return _S108;
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

fn lobe_at_0( record_4 : u32,  place_13 : Place_0) -> Lobe_0
{
    var lobe_0 : Lobe_0;
    lobe_0.record_3 = record_4;
    var is_black_0 : bool = record_4 == u32(4294967295);
    var _S109 : u32;
    if(is_black_0)
    {
        _S109 = u32(0);
    }
    else
    {
        _S109 = word_0(record_4);
    }
    lobe_0.kind_1 = _S109;
    if(is_black_0)
    {
        _S109 = u32(1);
    }
    else
    {
        _S109 = word_0(record_4 + u32(1));
    }
    lobe_0.distribution_0 = _S109;
    var _S110 : Numbers_0 = no_numbers_0();
    lobe_0.numbers_2 = _S110;
    lobe_0.changes_0 = _S110;
    if(is_black_0)
    {
        _S109 = u32(0);
    }
    else
    {
        _S109 = word_0(record_4 + u32(4));
    }
    var slot_1 : u32 = u32(0);
    for(;;)
    {
        if(slot_1 < _S109)
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
        var colour_1 : Vector_0 = shown_0(texture_6, place_13);
        var _S111 : vec3<f32> = value_of_0(colour_1);
        var _S112 : Numbers_0 = lobe_0.numbers_2;
        set_slot_0(&(_S112), slot_1, _S111);
        lobe_0.numbers_2 = _S112;
        var _S113 : vec3<f32> = change_of_0(colour_1);
        var _S114 : Numbers_0 = lobe_0.changes_0;
        set_slot_0(&(_S114), slot_1, _S113);
        lobe_0.changes_0 = _S114;
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
    var across_2 : vec3<f32> = cross(tangent_0, surface_3.outward_0);
    var _S115 : vec3<f32>;
    if((dot(across_2, across_2)) > 0.0f)
    {
        _S115 = tangent_0;
    }
    else
    {
        _S115 = vec3<f32>(0.0f);
    }
    return _S115;
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
    var _S116 : vec3<f32>;
    var _S117 : vec3<f32>;
    if(is_front_1)
    {
        _S116 = dpn_0.primal_0;
        _S117 = dpn_0.differential_0;
    }
    else
    {
        var _S118 : vec3<f32> = (vec3<f32>(0) - dpn_0.differential_0);
        _S116 = (vec3<f32>(0) - dpn_0.primal_0);
        _S117 = _S118;
    }
    var _S119 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpn_0.primal_0, dpn_0.differential_0 );
    var _S120 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dptangent_0.primal_0, dptangent_0.differential_0 );
    var _S121 : DiffPair_float_0 = _d_dot_1(_S119, _S120);
    var _S122 : vec3<f32> = vec3<f32>(_S121.primal_0);
    var _S123 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dptangent_0.primal_0 - dpn_0.primal_0 * _S122, dptangent_0.differential_0 - (dpn_0.differential_0 * _S122 + vec3<f32>(_S121.differential_0) * dpn_0.primal_0) );
    var _S124 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_normalize_impl_0(_S123);
    var _S125 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( _S124.primal_0, _S124.differential_0 );
    var _S126 : DiffPair_vectorx3Cfloatx2C3x3E_0 = _d_cross_0(_S119, _S125);
    var _S127 : Axes_0 = Axes_0( _S124.primal_0, _S126.primal_0, _S116 );
    var _S128 : Axes_0 = Axes_0( _S124.differential_0, _S126.differential_0, _S117 );
    var _S129 : DiffPair_Axes_0 = DiffPair_Axes_0( _S127, _S128 );
    return _S129;
}

fn s_fwd_axes_around_0( dpn_1 : DiffPair_vectorx3Cfloatx2C3x3E_0,  is_front_2 : bool) -> DiffPair_Axes_0
{
    var _S130 : vec3<f32>;
    var _S131 : vec3<f32>;
    if(is_front_2)
    {
        _S130 = dpn_1.primal_0;
        _S131 = dpn_1.differential_0;
    }
    else
    {
        var _S132 : vec3<f32> = (vec3<f32>(0) - dpn_1.differential_0);
        _S130 = (vec3<f32>(0) - dpn_1.primal_0);
        _S131 = _S132;
    }
    var _S133 : f32 = dpn_1.primal_0.z;
    var _S134 : f32 = dpn_1.differential_0.z;
    var sign_0 : f32;
    if(_S133 < -0.00000999999974738f)
    {
        sign_0 = -1.0f;
    }
    else
    {
        sign_0 = 1.0f;
    }
    var _S135 : f32 = sign_0 + _S133;
    var a_11 : f32 = -1.0f / _S135;
    var s_diff_a_0 : f32 = (0.0f - -1.0f * _S134) / (_S135 * _S135);
    var _S136 : f32 = dpn_1.primal_0.x;
    var _S137 : f32 = dpn_1.differential_0.x;
    var _S138 : f32 = dpn_1.primal_0.y;
    var _S139 : f32 = dpn_1.differential_0.y;
    var _S140 : f32 = _S136 * _S138;
    var b_5 : f32 = _S140 * a_11;
    var s_diff_b_0 : f32 = (_S137 * _S138 + _S139 * _S136) * a_11 + s_diff_a_0 * _S140;
    var _S141 : f32 = sign_0 * _S136;
    var _S142 : f32 = _S141 * _S136;
    var _S143 : f32 = - sign_0;
    var _S144 : f32 = _S138 * _S138;
    var _S145 : f32 = _S139 * _S138;
    var _S146 : Axes_0 = Axes_0( vec3<f32>(1.0f + _S142 * a_11, sign_0 * b_5, _S143 * _S136), vec3<f32>(b_5, sign_0 + _S144 * a_11, - _S138), _S130 );
    var _S147 : Axes_0 = Axes_0( vec3<f32>((_S137 * sign_0 * _S136 + _S137 * _S141) * a_11 + s_diff_a_0 * _S142, s_diff_b_0 * sign_0, _S137 * _S143), vec3<f32>(s_diff_b_0, (_S145 + _S145) * a_11 + s_diff_a_0 * _S144, - _S139), _S131 );
    var _S148 : DiffPair_Axes_0 = DiffPair_Axes_0( _S146, _S147 );
    return _S148;
}

fn to_local_0( axes_0 : Axes_0,  v_3 : vec3<f32>) -> vec3<f32>
{
    return vec3<f32>(dot(axes_0.s_0, v_3), dot(axes_0.t_0, v_3), dot(axes_0.n_1, v_3));
}

fn s_fwd_to_local_0( dpaxes_0 : DiffPair_Axes_0,  dpv_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S149 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpaxes_0.primal_0.s_0, dpaxes_0.differential_0.s_0 );
    var _S150 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpv_0.primal_0, dpv_0.differential_0 );
    var _S151 : DiffPair_float_0 = _d_dot_1(_S149, _S150);
    var _S152 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpaxes_0.primal_0.t_0, dpaxes_0.differential_0.t_0 );
    var _S153 : DiffPair_float_0 = _d_dot_1(_S152, _S150);
    var _S154 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpaxes_0.primal_0.n_1, dpaxes_0.differential_0.n_1 );
    var _S155 : DiffPair_float_0 = _d_dot_1(_S154, _S150);
    var _S156 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( vec3<f32>(_S151.primal_0, _S153.primal_0, _S155.primal_0), vec3<f32>(_S151.differential_0, _S153.differential_0, _S155.differential_0) );
    return _S156;
}

fn s_fwd_towards_viewer_0( dpaxes_1 : DiffPair_Axes_0,  dpdirection_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S157 : DiffPair_Axes_0 = DiffPair_Axes_0( dpaxes_1.primal_0, dpaxes_1.differential_0 );
    var _S158 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpdirection_0.primal_0, dpdirection_0.differential_0 );
    var _S159 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_to_local_0(_S157, _S158);
    var wi_0 : vec3<f32> = (vec3<f32>(0) - _S159.primal_0);
    var s_diff_wi_0 : vec3<f32> = (vec3<f32>(0) - _S159.differential_0);
    var _S160 : DiffPair_float_0 = DiffPair_float_0( wi_0.z, s_diff_wi_0.z );
    var _S161 : DiffPair_float_0 = _d_abs_0(_S160);
    var _S162 : DiffPair_float_0 = DiffPair_float_0( _S161.primal_0, _S161.differential_0 );
    var _S163 : DiffPair_float_0 = DiffPair_float_0( 9.999999960041972e-13f, 0.0f );
    var _S164 : DiffPair_float_0 = _d_max_0(_S162, _S163);
    var _S165 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( vec3<f32>(wi_0.x, wi_0.y, _S164.primal_0), vec3<f32>(s_diff_wi_0.x, s_diff_wi_0.y, _S164.differential_0) );
    return _S165;
}

struct Vertex_0
{
     surface_4 : Surface_0,
     axes_1 : Axes_0,
     lobe_1 : Lobe_0,
     wi_1 : Vector_0,
     axes_change_0 : Axes_0,
};

fn vertex_at_0( surface_5 : Surface_0,  material_0 : u32,  direction_5 : Vector_0) -> Vertex_0
{
    var vertex_0 : Vertex_0;
    vertex_0.surface_4 = surface_5;
    var _S166 : Lobe_0 = lobe_at_0(material_0, surface_5.place_3);
    vertex_0.lobe_1 = _S166;
    var tangent_1 : vec3<f32> = tangent_at_0(surface_5);
    var _S167 : vec3<f32> = vec3<f32>(0.0f);
    var tangent_change_0 : vec3<f32>;
    if(is_moving_0())
    {
        tangent_change_0 = change_vector_0(motion_of_0(surface_5.place_3.triangle_0) + u32(18));
    }
    else
    {
        tangent_change_0 = _S167;
    }
    var _S168 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( surface_5.outward_0, surface_5.outward_change_0 );
    var axes_2 : DiffPair_Axes_0;
    if((any((tangent_1 != _S167))))
    {
        var _S169 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( tangent_1, tangent_change_0 );
        axes_2 = s_fwd_axes_along_0(_S168, _S169, surface_5.is_front_0);
    }
    else
    {
        axes_2 = s_fwd_axes_around_0(_S168, surface_5.is_front_0);
    }
    vertex_0.axes_1 = axes_2.primal_0;
    vertex_0.axes_change_0 = axes_2.differential_0;
    var _S170 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( value_of_0(direction_5), change_of_0(direction_5) );
    var _S171 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_towards_viewer_0(axes_2, _S170);
    vertex_0.wi_1 = changing_0(_S171.primal_0, _S171.differential_0);
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

fn is_area_0( record_5 : u32) -> bool
{
    return (word_0(record_5)) == u32(0);
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
    var _S172 : f32 = min(highest_0, 1.0f);
    return area_0 * _S172 * _S172 / (2.0f * (_S172 - max(lowest_0, -1.0f)) * squared_0);
}

fn is_sampled_well_0( position_1 : vec3<f32>) -> bool
{
    var _S173 : bool;
    if((word_0(u32(6))) != u32(1))
    {
        _S173 = true;
    }
    else
    {
        _S173 = (word_0(u32(2))) == u32(0);
    }
    if(_S173)
    {
        return false;
    }
    var record_6 : u32 = emitter_record_0(u32(0));
    if(is_area_0(record_6))
    {
        _S173 = (node_seen_0(word_0(record_6 + u32(5)), position_1)) < 1.0f;
    }
    else
    {
        _S173 = false;
    }
    return _S173;
}

fn has_smooth_0( lobe_2 : Lobe_0) -> bool
{
    return (lobe_2.kind_1) != u32(1);
}

fn largest_cosine_0( position_2 : vec3<f32>,  normal_2 : vec3<f32>,  centre_0 : vec3<f32>,  radius_1 : f32) -> f32
{
    var offset_1 : vec3<f32> = centre_0 - position_2;
    var distance_1 : f32 = length(offset_1);
    if(distance_1 <= radius_1)
    {
        return 1.0f;
    }
    var cosine_1 : f32 = dot(offset_1, normal_2) / distance_1;
    var sine_ball_0 : f32 = radius_1 / distance_1;
    var cosine_ball_0 : f32 = sqrt(max(1.0f - sine_ball_0 * sine_ball_0, 0.0f));
    if(cosine_1 >= cosine_ball_0)
    {
        return 1.0f;
    }
    return max(cosine_1 * cosine_ball_0 + sqrt(max(1.0f - cosine_1 * cosine_1, 0.0f)) * sine_ball_0 + 9.99999997475242708e-07f, 0.0f);
}

fn emitter_view_0( emitter_1 : u32,  position_3 : vec3<f32>,  normal_3 : vec3<f32>) -> f32
{
    var record_7 : u32 = emitter_record_0(emitter_1);
    if(!is_area_0(record_7))
    {
        return 3.14159274101257324f;
    }
    return node_seen_0(word_0(record_7 + u32(5)), position_3) * largest_cosine_0(position_3, normal_3, vector_at_0(record_7 + u32(8)), number_0(record_7 + u32(11)));
}

struct Choice_0
{
     position_4 : vec3<f32>,
     normal_4 : vec3<f32>,
     all_0 : f32,
     lit_0 : f32,
};

fn light_of_0( emitter_2 : u32,  choice_0 : Choice_0,  can_light_0 : ptr<function, f32>) -> f32
{
    var view_0 : f32 = emitter_view_0(emitter_2, choice_0.position_4, choice_0.normal_4);
    var _S174 : f32;
    if(view_0 > 0.0f)
    {
        _S174 = 1.0f;
    }
    else
    {
        _S174 = 0.0f;
    }
    (*can_light_0) = _S174;
    return view_0 * number_0(emitter_record_0(emitter_2) + u32(2));
}

fn light_of_1( emitter_3 : u32,  choice_1 : Choice_0,  can_light_1 : ptr<function, f32>) -> f32
{
    var view_1 : f32 = emitter_view_0(emitter_3, choice_1.position_4, choice_1.normal_4);
    var _S175 : f32;
    if(view_1 > 0.0f)
    {
        _S175 = 1.0f;
    }
    else
    {
        _S175 = 0.0f;
    }
    (*can_light_1) = _S175;
    return view_1 * number_0(emitter_record_0(emitter_3) + u32(2));
}

fn choice_at_0( position_5 : vec3<f32>,  normal_5 : vec3<f32>,  alike_0 : bool) -> Choice_0
{
    var choice_2 : Choice_0;
    choice_2.position_4 = position_5;
    choice_2.normal_4 = normal_5;
    choice_2.all_0 = 0.0f;
    choice_2.lit_0 = 0.0f;
    var count_1 : u32 = word_0(u32(6));
    var _S176 : bool;
    if(alike_0)
    {
        _S176 = true;
    }
    else
    {
        _S176 = (word_0(u32(5))) != u32(0);
    }
    if(_S176)
    {
        _S176 = true;
    }
    else
    {
        _S176 = count_1 < u32(2);
    }
    if(_S176)
    {
        _S176 = true;
    }
    else
    {
        _S176 = count_1 > u32(32);
    }
    if(_S176)
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
        var _S177 : f32 = light_of_1(i_1, choice_2, &(can_light_2));
        choice_2.all_0 = choice_2.all_0 + _S177;
        choice_2.lit_0 = choice_2.lit_0 + can_light_2;
        i_1 = i_1 + u32(1);
    }
    if((choice_2.all_0) > 0.0f)
    {
        _S176 = (choice_2.all_0) < 3.00000000549775576e+38f;
    }
    else
    {
        _S176 = false;
    }
    if(!_S176)
    {
        choice_2.all_0 = 0.0f;
    }
    return choice_2;
}

fn limit_at_0( which_5 : u32) -> f64
{
    return primitives_0[word_0(u32(15)) + which_5];
}

fn product_0( a_12 : u32,  b_6 : u32) -> vec2<u32>
{
    var a0_0 : u32 = (a_12 & (u32(65535)));
    var a1_0 : u32 = (a_12 >> (u32(16)));
    var b0_0 : u32 = (b_6 & (u32(65535)));
    var b1_0 : u32 = (b_6 >> (u32(16)));
    var low_0 : u32 = a0_0 * b0_0;
    var middle_0 : u32 = a1_0 * b0_0 + ((low_0 >> (u32(16))));
    var rest_0 : u32 = ((middle_0 & (u32(65535)))) + a0_0 * b1_0;
    return vec2<u32>((((rest_0 << (u32(16)))) | (((low_0 & (u32(65535)))))), a1_0 * b1_0 + ((middle_0 >> (u32(16)))) + ((rest_0 >> (u32(16)))));
}

fn times_0( a_13 : vec2<u32>,  b_7 : vec2<u32>) -> vec2<u32>
{
    var _S178 : u32 = a_13.x;
    var _S179 : u32 = b_7.x;
    var low_1 : vec2<u32> = product_0(_S178, _S179);
    return vec2<u32>(low_1.x, low_1.y + _S178 * b_7.y + a_13.y * _S179);
}

fn plus_0( a_14 : vec2<u32>,  b_8 : vec2<u32>) -> vec2<u32>
{
    var _S180 : u32 = a_14.x;
    var low_2 : u32 = _S180 + b_8.x;
    var _S181 : u32 = a_14.y + b_8.y;
    var _S182 : i32;
    if(low_2 < _S180)
    {
        _S182 = i32(1);
    }
    else
    {
        _S182 = i32(0);
    }
    return vec2<u32>(low_2, _S181 + u32(_S182));
}

fn shifted_xor_0( x_2 : vec2<u32>,  by_0 : u32) -> vec2<u32>
{
    var _S183 : u32 = x_2.y;
    return (x_2 ^ (vec2<u32>(((((x_2.x) >> (by_0))) | (((_S183 << ((u32(32) - by_0)))))), (_S183 >> (by_0)))));
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
        var _S184 : f32 = f32(count_2);
        (*probability_0) = 1.0f / _S184;
        return min(u32(u_0 * _S184), count_2 - u32(1));
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
        var _S185 : u32 = i_2 + u32(1);
        found_0 = found_1;
        i_2 = _S185;
        rest_1 = rest_2;
    }
    return found_0;
}

fn place_at_0( triangle_7 : u32,  v_4 : f32,  w_2 : f32) -> Place_0
{
    return exact_place_0(triangle_7, f64(v_4), f64(w_2));
}

fn angle_of_0( x_4 : f32,  y_1 : f32) -> f32
{
    var _S186 : f32 = abs(x_4);
    var _S187 : f32 = abs(y_1);
    var _S188 : f32 = min(_S186, _S187);
    var _S189 : f32 = max(_S186, _S187);
    var is_steep_0 : bool = _S188 > (0.41421356797218323f * _S189);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S188 - _S189;
    }
    else
    {
        above_0 = _S188;
    }
    var below_0 : f32;
    if(is_steep_0)
    {
        below_0 = _S188 + _S189;
    }
    else
    {
        below_0 = _S189;
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
    if(_S187 > _S186)
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

fn s_fwd_angle_of_0( dpx_10 : DiffPair_float_0,  dpy_5 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S190 : DiffPair_float_0 = DiffPair_float_0( dpx_10.primal_0, dpx_10.differential_0 );
    var _S191 : DiffPair_float_0 = _d_abs_0(_S190);
    var _S192 : DiffPair_float_0 = DiffPair_float_0( dpy_5.primal_0, dpy_5.differential_0 );
    var _S193 : DiffPair_float_0 = _d_abs_0(_S192);
    var _S194 : DiffPair_float_0 = DiffPair_float_0( _S191.primal_0, _S191.differential_0 );
    var _S195 : DiffPair_float_0 = DiffPair_float_0( _S193.primal_0, _S193.differential_0 );
    var _S196 : DiffPair_float_0 = _d_min_0(_S194, _S195);
    var _S197 : DiffPair_float_0 = _d_max_0(_S194, _S195);
    var is_steep_1 : bool = (_S196.primal_0) > (0.41421356797218323f * _S197.primal_0);
    var above_1 : f32;
    var s_diff_above_0 : f32;
    if(is_steep_1)
    {
        var _S198 : f32 = _S196.differential_0 - _S197.differential_0;
        above_1 = _S196.primal_0 - _S197.primal_0;
        s_diff_above_0 = _S198;
    }
    else
    {
        above_1 = _S196.primal_0;
        s_diff_above_0 = _S196.differential_0;
    }
    var below_1 : f32;
    var s_diff_below_0 : f32;
    if(is_steep_1)
    {
        var _S199 : f32 = _S196.differential_0 + _S197.differential_0;
        below_1 = _S196.primal_0 + _S197.primal_0;
        s_diff_below_0 = _S199;
    }
    else
    {
        below_1 = _S197.primal_0;
        s_diff_below_0 = _S197.differential_0;
    }
    if(below_1 > 0.0f)
    {
    }
    else
    {
        below_1 = 1.0f;
        s_diff_below_0 = 0.0f;
    }
    var t_2 : f32 = above_1 / below_1;
    var s_diff_t_0 : f32 = (s_diff_above_0 * below_1 - above_1 * s_diff_below_0) / (below_1 * below_1);
    var z_1 : f32 = t_2 * t_2;
    var _S200 : f32 = s_diff_t_0 * t_2;
    var s_diff_z_0 : f32 = _S200 + _S200;
    var _S201 : f32 = 0.08053744584321976f * z_1 - 0.13877685368061066f;
    var _S202 : f32 = _S201 * z_1 + 0.19977711141109467f;
    var tail_0 : f32 = _S202 * z_1 - 0.33332949876785278f;
    var _S203 : f32 = tail_0 * z_1;
    var angle_2 : f32 = _S203 * t_2 + t_2;
    var s_diff_angle_0 : f32 = (((s_diff_z_0 * 0.08053744584321976f * z_1 + s_diff_z_0 * _S201) * z_1 + s_diff_z_0 * _S202) * z_1 + s_diff_z_0 * tail_0) * t_2 + s_diff_t_0 * _S203 + s_diff_t_0;
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
    if((_S193.primal_0) > (_S191.primal_0))
    {
        var _S204 : f32 = 0.0f - s_diff_angle_0;
        angle_3 = 1.57079637050628662f - angle_3;
        s_diff_angle_1 = _S204;
    }
    else
    {
        s_diff_angle_1 = s_diff_angle_0;
    }
    if((dpx_10.primal_0) < 0.0f)
    {
        var _S205 : f32 = 0.0f - s_diff_angle_1;
        angle_3 = 3.14159274101257324f - angle_3;
        s_diff_angle_1 = _S205;
    }
    if((dpy_5.primal_0) < 0.0f)
    {
        var _S206 : f32 = - s_diff_angle_1;
        above_1 = - angle_3;
        s_diff_above_0 = _S206;
    }
    else
    {
        above_1 = angle_3;
        s_diff_above_0 = s_diff_angle_1;
    }
    var _S207 : DiffPair_float_0 = DiffPair_float_0( above_1, s_diff_above_0 );
    return _S207;
}

fn solid_angle_of_0( a_15 : vec3<f32>,  b_9 : vec3<f32>,  c_4 : vec3<f32>) -> f32
{
    var la_0 : f32 = length(a_15);
    var lb_0 : f32 = length(b_9);
    var lc_0 : f32 = length(c_4);
    var normal_6 : vec3<f32> = cross(b_9 - a_15, c_4 - a_15);
    var volume_0 : f32 = - dot(a_15, normal_6);
    if(!(volume_0 > (9.99999997475242708e-07f * max(max(la_0, lb_0), lc_0) * length(normal_6))))
    {
        return 0.0f;
    }
    return 2.0f * angle_of_0(la_0 * lb_0 * lc_0 + dot(a_15, b_9) * lc_0 + dot(b_9, c_4) * la_0 + dot(c_4, a_15) * lb_0, volume_0);
}

fn complex_product_0( a_16 : vec2<f32>,  b_10 : vec2<f32>) -> vec2<f32>
{
    var _S208 : f32 = a_16.x;
    var _S209 : f32 = b_10.x;
    var _S210 : f32 = a_16.y;
    var _S211 : f32 = b_10.y;
    return vec2<f32>(_S208 * _S209 - _S210 * _S211, _S208 * _S211 + _S210 * _S209);
}

struct SeenRectangle_0
{
     x_5 : vec2<f32>,
     y_2 : vec2<f32>,
     z_2 : f32,
     solid_angle_0 : f32,
     start_0 : vec2<f32>,
     inverse_to_line_0 : vec2<f32>,
};

fn seen_rectangle_0( at_18 : u32,  viewpoint_1 : vec3<f32>) -> SeenRectangle_0
{
    var offset_2 : vec3<f32> = vector_at_0(at_18) - viewpoint_1;
    var x0_0 : f32 = dot(vector_at_0(at_18 + u32(3)), offset_2);
    var y0_0 : f32 = dot(vector_at_0(at_18 + u32(6)), offset_2);
    var x1_0 : f32 = x0_0 + number_0(at_18 + u32(12));
    var y1_0 : f32 = y0_0 + number_0(at_18 + u32(13));
    var seen_1 : SeenRectangle_0;
    seen_1.x_5 = vec2<f32>(x0_0, x1_0);
    seen_1.y_2 = vec2<f32>(y0_0, y1_0);
    var _S212 : f32 = - dot(vector_at_0(at_18 + u32(9)), offset_2);
    seen_1.z_2 = _S212;
    var a_17 : vec3<f32> = vec3<f32>(x0_0, y0_0, _S212);
    var b_11 : vec3<f32> = vec3<f32>(x1_0, y0_0, _S212);
    var c_5 : vec3<f32> = vec3<f32>(x0_0, y1_0, _S212);
    var d_0 : vec3<f32> = vec3<f32>(x1_0, y1_0, _S212);
    var _S213 : f32 = length(a_17);
    var _S214 : f32 = length(c_5);
    var _S215 : f32;
    if(_S212 > (9.99999997475242708e-07f * max(max(_S213, length(b_11)), max(_S214, length(d_0)))))
    {
        _S215 = solid_angle_of_0(a_17, c_5, b_11) + solid_angle_of_0(d_0, b_11, c_5);
    }
    else
    {
        _S215 = 0.0f;
    }
    seen_1.solid_angle_0 = _S215;
    var z2_0 : f32 = seen_1.z_2 * seen_1.z_2;
    var at_first_0 : vec2<f32> = complex_product_0(vec2<f32>(x0_0 * y1_0, seen_1.z_2 * _S214), vec2<f32>(- x0_0 * y0_0, seen_1.z_2 * _S213));
    var to_line_0 : vec2<f32> = sqrt(seen_1.y_2 * seen_1.y_2 + vec2<f32>(z2_0));
    seen_1.start_0 = vec2<f32>(at_first_0.x, - at_first_0.y) * vec2<f32>((1.0f / ((x0_0 * x0_0 + z2_0) * to_line_0.x * to_line_0.y)));
    seen_1.inverse_to_line_0 = vec2<f32>(1.0f) / to_line_0;
    return seen_1;
}

fn sine_cosine_0( angle_4 : f32) -> vec2<f32>
{
    var quarters_0 : f32 = floor(angle_4 * 0.63661974668502808f + 0.5f);
    var x_6 : f32 = angle_4 - quarters_0 * 1.5703125f - quarters_0 * 0.00048375129699707f - quarters_0 * 7.54979012640433211e-08f;
    var z_3 : f32 = x_6 * x_6;
    var sine_1 : f32 = ((-0.00019515295571182f * z_3 + 0.00833216123282909f) * z_3 - 0.16666655242443085f) * z_3 * x_6 + x_6;
    var cosine_2 : f32 = ((0.00002443315679557f * z_3 - 0.00138873164542019f) * z_3 + 0.04166664555668831f) * z_3 * z_3 - 0.5f * z_3 + 1.0f;
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
    var at_19 : vec2<f32> = complex_product_0(seen_2.start_0, vec2<f32>(turn_0.y, turn_0.x));
    var _S216 : f32 = seen_2.y_2.x;
    var _S217 : f32 = seen_2.inverse_to_line_0.x;
    var _S218 : f32 = seen_2.y_2.y;
    var n_2 : f32 = - at_19.x * _S216 * _S217 - _S218 * seen_2.inverse_to_line_0.y;
    var _S219 : f32 = at_19.y;
    var flat_0 : f32 = _S219 * seen_2.z_2 * _S217;
    var size_2 : f32 = seen_2.z_2 * abs(_S219) / sqrt(max(n_2 * n_2 - flat_0 * flat_0, 0.0f));
    var _S220 : f32;
    if((n_2 * _S219) < 0.0f)
    {
        _S220 = - size_2;
    }
    else
    {
        _S220 = size_2;
    }
    var x_7 : f32 = clamp(_S220, seen_2.x_5.x, seen_2.x_5.y);
    var squared_1 : f32 = x_7 * x_7 + seen_2.z_2 * seen_2.z_2;
    var h_0 : vec2<f32> = seen_2.y_2 / sqrt(vec2<f32>(squared_1) + seen_2.y_2 * seen_2.y_2);
    var _S221 : f32 = h_0.x;
    var sine_2 : f32 = _S221 + u_1.y * (h_0.y - _S221);
    return vec2<f32>(x_7, clamp(sine_2 * sqrt(squared_1 / max((1.0f - sine_2) * (1.0f + sine_2), 0.0f)), _S216, _S218));
}

fn rectangle_face_0( at_20 : u32,  place_14 : vec2<f32>,  weights_2 : ptr<function, vec2<f32>>) -> u32
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
        var row_1 : u32 = at_20 + u32(14) + u32(6) * face_0;
        var _S222 : f32 = place_14.x;
        var _S223 : f32 = place_14.y;
        var v_5 : f32 = number_0(row_1) + number_0(row_1 + u32(1)) * _S222 + number_0(row_1 + u32(2)) * _S223;
        var w_3 : f32 = number_0(row_1 + u32(3)) + number_0(row_1 + u32(4)) * _S222 + number_0(row_1 + u32(5)) * _S223;
        var _S224 : f32 = min(min(v_5, w_3), 1.0f - v_5 - w_3);
        if(_S224 > best_0)
        {
            (*weights_2)[i32(0)] = clamp(v_5, 0.0f, 1.0f);
            (*weights_2)[i32(1)] = clamp(w_3, 0.0f, 1.0f - (*weights_2).x);
            best_0 = _S224;
            found_2 = face_0;
        }
        face_0 = face_0 + u32(1);
    }
    return found_2;
}

fn emitter_triangle_0( record_8 : u32,  face_1 : u32) -> u32
{
    return word_0(word_0(u32(12)) + word_0(record_8 + u32(3)) + face_1);
}

fn precise_random_0( key_3 : vec2<u32>,  dimension_2 : u32) -> f64
{
    var bits_0 : vec2<u32> = random_bits_0(key_3, dimension_2);
    var _S225 : u32 = bits_0.y;
    return (f64((_S225 >> (u32(11)))) + f64((((_S225 << (u32(21)))) | ((((bits_0.x) >> (u32(11))))))) / 2048.0lf / 2048.0lf / 1024.0lf) / 2048.0lf / 1024.0lf;
}

fn shares_of_0( nodes_at_0 : u32,  node_1 : u32,  viewpoint_2 : vec3<f32>) -> vec2<f32>
{
    var _S226 : f32 = node_seen_0(nodes_at_0 + u32(17) * word_0(node_1 + u32(2)), viewpoint_2);
    var _S227 : f32 = node_seen_0(nodes_at_0 + u32(17) * word_0(node_1 + u32(3)), viewpoint_2);
    var seen_3 : vec2<f32> = vec2<f32>(_S226, _S227);
    var sum_0 : f32 = _S226 + _S227;
    var _S228 : vec2<f32>;
    if(sum_0 > 0.0f)
    {
        _S228 = seen_3 / vec2<f32>(sum_0);
    }
    else
    {
        _S228 = vec2<f32>(0.0f);
    }
    return _S228;
}

struct Corners_0
{
     a_18 : vec3<f32>,
     b_12 : vec3<f32>,
     c_6 : vec3<f32>,
};

fn corners_from_0( record_9 : u32,  face_2 : u32,  viewpoint_3 : vec3<f64>) -> Corners_0
{
    var at_21 : u32 = u32(9) * emitter_triangle_0(record_9, face_2);
    var corners_0 : Corners_0;
    corners_0.a_18 = vec3<f32>(primitive_vector_0(at_21) - viewpoint_3);
    corners_0.b_12 = vec3<f32>(primitive_vector_0(at_21 + u32(3)) - viewpoint_3);
    corners_0.c_6 = vec3<f32>(primitive_vector_0(at_21 + u32(6)) - viewpoint_3);
    return corners_0;
}

fn face_solid_angle_0( record_10 : u32,  face_3 : u32,  viewpoint_4 : vec3<f64>) -> f32
{
    var corners_1 : Corners_0 = corners_from_0(record_10, face_3, viewpoint_4);
    return solid_angle_of_0(corners_1.a_18, corners_1.b_12, corners_1.c_6);
}

fn unit_across_0( v_6 : vec3<f32>,  axis_1 : vec3<f32>) -> vec3<f32>
{
    return normalize(v_6 - axis_1 * vec3<f32>(dot(v_6, axis_1)));
}

fn along_0( from_0 : vec3<f32>,  to_0 : vec3<f32>,  cosine_3 : f32) -> vec3<f32>
{
    var _S229 : f32 = clamp(cosine_3, -1.0f, 1.0f);
    return from_0 * vec3<f32>(_S229) + unit_across_0(to_0, from_0) * vec3<f32>(sqrt((1.0f - _S229) * (1.0f + _S229)));
}

fn triangle_direction_0( a_19 : vec3<f32>,  b_13 : vec3<f32>,  c_7 : vec3<f32>,  area_1 : f32,  u_2 : vec2<f32>) -> vec3<f32>
{
    var _S230 : vec3<f32> = normalize(a_19);
    var _S231 : vec3<f32> = normalize(b_13);
    var _S232 : vec3<f32> = normalize(c_7);
    var ab_1 : vec3<f32> = normalize(cross(_S230, _S231));
    var ca_0 : vec3<f32> = normalize(cross(_S232, _S230));
    var sine_alpha_0 : f32 = length(cross(ab_1, ca_0));
    var cosine_alpha_0 : f32 = - dot(ab_1, ca_0);
    var part_0 : vec2<f32> = sine_cosine_0(u_2.x * area_1);
    var _S233 : f32 = part_0.x;
    var _S234 : f32 = part_0.y;
    var sine_phi_0 : f32 = _S233 * cosine_alpha_0 - _S234 * sine_alpha_0;
    var cosine_phi_0 : f32 = _S234 * cosine_alpha_0 + _S233 * sine_alpha_0;
    var k1_0 : f32 = cosine_phi_0 - cosine_alpha_0;
    var k2_0 : f32 = sine_phi_0 + sine_alpha_0 * dot(_S230, _S231);
    var between_1 : vec3<f32> = along_0(_S230, _S232, ((k2_0 * cosine_phi_0 - k1_0 * sine_phi_0) * cosine_alpha_0 - k2_0) / ((k2_0 * sine_phi_0 + k1_0 * cosine_phi_0) * sine_alpha_0));
    return along_0(_S231, between_1, 1.0f - u_2.y * (1.0f - dot(between_1, _S231)));
}

fn density_of_0( solid_angle_1 : f32,  normal_7 : vec3<f32>,  distance_2 : f32,  direction_6 : vec3<f32>) -> f32
{
    if(!(solid_angle_1 < 0.00100000004749745f))
    {
        return 1.0f;
    }
    return solid_angle_1 * 2.0f * distance_2 * distance_2 / abs(dot(normal_7, direction_6));
}

struct EmitterPoint_0
{
     place_15 : Place_0,
     pdf_0 : f32,
};

fn area_point_0( record_11 : u32,  from_1 : Surface_0,  key_4 : vec2<u32>,  dimension_3 : u32) -> EmitterPoint_0
{
    var total_0 : f32;
    var point_0 : EmitterPoint_0;
    point_0.pdf_0 = 0.0f;
    point_0.place_15 = place_at_0(u32(0), 0.0f, 0.0f);
    var second_1 : f32 = random_0(key_4, dimension_3 + u32(1));
    var rectangle_0 : u32 = word_0(record_11 + u32(4));
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
            point_0.place_15.triangle_0 = emitter_triangle_0(record_11, face_4);
            point_0.place_15.v_0 = weights_3.x;
            point_0.place_15.w_0 = weights_3.y;
            point_0.pdf_0 = 1.0f / seen_4.solid_angle_0;
            return point_0;
        }
    }
    var _S235 : f64 = precise_random_0(key_4, dimension_3);
    var nodes_at_1 : u32 = word_0(record_11 + u32(5));
    var node_2 : u32 = nodes_at_1;
    var u_3 : f64 = _S235;
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
        var _S236 : f32 = shares_0.x;
        var _S237 : f32 = shares_0.y;
        if(!((_S236 + _S237) > 0.0f))
        {
            return point_0;
        }
        var _S238 : f64 = f64(_S236);
        var is_second_0 : bool;
        if(u_3 >= _S238)
        {
            is_second_0 = _S237 > 0.0f;
        }
        else
        {
            is_second_0 = false;
        }
        if(is_second_0)
        {
            u_3 = (u_3 - _S238) / f64(_S237);
        }
        else
        {
            u_3 = min(u_3 / _S238, 1.0lf);
        }
        if(is_second_0)
        {
            total_0 = _S237;
        }
        else
        {
            total_0 = _S236;
        }
        var chosen_1 : f32 = chosen_0 * total_0;
        var _S239 : i32;
        if(is_second_0)
        {
            _S239 = i32(3);
        }
        else
        {
            _S239 = i32(2);
        }
        node_2 = nodes_at_1 + u32(17) * word_0(node_2 + u32(_S239));
        chosen_0 = chosen_1;
    }
    var first_3 : u32 = word_0(node_2);
    var _S240 : u32 = word_0(node_2 + u32(1));
    var _S241 : u32 = word_0(record_11 + u32(6));
    var k_3 : u32 = first_3;
    total_0 = 0.0f;
    for(;;)
    {
        if(k_3 < _S240)
        {
        }
        else
        {
            break;
        }
        var total_1 : f32 = total_0 + face_solid_angle_0(record_11, word_0(_S241 + k_3), from_1.exact_0);
        k_3 = k_3 + u32(1);
        total_0 = total_1;
    }
    var _S242 : f32 = f32(u_3) * total_0;
    var face_5 : u32 = u32(4294967295);
    var angle_5 : f32 = 0.0f;
    var inside_2 : f32 = 0.0f;
    k_3 = first_3;
    var rest_3 : f32 = _S242;
    for(;;)
    {
        if(k_3 < _S240)
        {
        }
        else
        {
            break;
        }
        var _S243 : u32 = _S241 + k_3;
        var own_1 : f32 = face_solid_angle_0(record_11, word_0(_S243), from_1.exact_0);
        if(!(own_1 > 0.0f))
        {
            k_3 = k_3 + u32(1);
            continue;
        }
        var _S244 : u32 = word_0(_S243);
        var _S245 : f32 = min(rest_3 / own_1, 1.0f);
        if(rest_3 < own_1)
        {
            face_5 = _S244;
            angle_5 = own_1;
            inside_2 = _S245;
            break;
        }
        var rest_4 : f32 = rest_3 - own_1;
        face_5 = _S244;
        angle_5 = own_1;
        inside_2 = _S245;
        rest_3 = rest_4;
        k_3 = k_3 + u32(1);
    }
    if(face_5 == u32(4294967295))
    {
        return point_0;
    }
    var corners_2 : Corners_0 = corners_from_0(record_11, face_5, from_1.exact_0);
    var ab_2 : vec3<f32> = corners_2.b_12 - corners_2.a_18;
    var ac_1 : vec3<f32> = corners_2.c_6 - corners_2.a_18;
    var normal_8 : vec3<f32> = cross(ab_2, ac_1);
    point_0.place_15.triangle_0 = emitter_triangle_0(record_11, face_5);
    if(angle_5 < 0.00100000004749745f)
    {
        var root_0 : f32 = sqrt(inside_2);
        point_0.place_15.v_0 = root_0 * (1.0f - second_1);
        point_0.place_15.w_0 = root_0 * second_1;
    }
    else
    {
        var direction_7 : vec3<f32> = triangle_direction_0(corners_2.a_18, corners_2.b_12, corners_2.c_6, angle_5, vec2<f32>(inside_2, second_1));
        var within_0 : vec3<f32> = direction_7 * vec3<f32>((dot(corners_2.a_18, normal_8) / dot(direction_7, normal_8))) - corners_2.a_18;
        var squared_2 : f32 = dot(normal_8, normal_8);
        var _S246 : f32 = clamp(dot(cross(within_0, ac_1), normal_8) / squared_2, 0.0f, 1.0f);
        point_0.place_15.v_0 = _S246;
        point_0.place_15.w_0 = clamp(dot(cross(ab_2, within_0), normal_8) / squared_2, 0.0f, 1.0f - _S246);
    }
    var offset_3 : vec3<f32> = corners_2.a_18 + ab_2 * vec3<f32>(point_0.place_15.v_0) + ac_1 * vec3<f32>(point_0.place_15.w_0);
    var distance_3 : f32 = length(offset_3);
    if(!(distance_3 > 0.0f))
    {
        return point_0;
    }
    point_0.pdf_0 = chosen_0 / total_0 * density_of_0(angle_5, normal_8, distance_3, offset_3 / vec3<f32>(distance_3));
    return point_0;
}

fn is_map_0( record_12 : u32) -> bool
{
    return (word_0(record_12)) == u32(2);
}

fn uniform_direction_0( u_4 : vec2<f32>) -> vec3<f32>
{
    var _S247 : f32 = u_4.x;
    var turn_1 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_4.y) * vec2<f32>((2.0f * sqrt(_S247 * (1.0f - _S247))));
    return vec3<f32>(turn_1.y, turn_1.x, 1.0f - 2.0f * _S247);
}

fn map_place_0( map_0 : u32,  direction_8 : vec3<f32>) -> vec2<f32>
{
    var _S248 : u32 = map_0 + u32(2);
    var d_1 : vec3<f32> = vector_at_0(_S248) * vec3<f32>(direction_8.x) + vector_at_0(_S248 + u32(3)) * vec3<f32>(direction_8.y) + vector_at_0(_S248 + u32(6)) * vec3<f32>(direction_8.z);
    return vec2<f32>(angle_of_0(- d_1.z, d_1.x) * 0.15915493667125702f * f32(word_0(map_0)) - 0.5f, angle_of_0(d_1.y, length(d_1.xz)) * 0.31830987334251404f * (f32(word_0(map_0 + u32(1))) - 1.0f));
}

fn s_fwd_map_place_0( map_1 : u32,  dpdirection_1 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C2x3E_0
{
    var _S249 : u32 = map_1 + u32(2);
    var _S250 : vec3<f32> = vector_at_0(_S249);
    var _S251 : vec3<f32> = vector_at_0(_S249 + u32(3));
    var _S252 : vec3<f32> = vector_at_0(_S249 + u32(6));
    var d_2 : vec3<f32> = _S250 * vec3<f32>(dpdirection_1.primal_0.x) + _S251 * vec3<f32>(dpdirection_1.primal_0.y) + _S252 * vec3<f32>(dpdirection_1.primal_0.z);
    var s_diff_d_0 : vec3<f32> = vec3<f32>(dpdirection_1.differential_0.x) * _S250 + vec3<f32>(dpdirection_1.differential_0.y) * _S251 + vec3<f32>(dpdirection_1.differential_0.z) * _S252;
    var _S253 : DiffPair_float_0 = DiffPair_float_0( - d_2.z, - s_diff_d_0.z );
    var _S254 : DiffPair_float_0 = DiffPair_float_0( d_2.x, s_diff_d_0.x );
    var _S255 : DiffPair_float_0 = s_fwd_angle_of_0(_S253, _S254);
    var _S256 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( d_2.xz, s_diff_d_0.xz );
    var _S257 : DiffPair_float_0 = s_fwd_length_impl_1(_S256);
    var _S258 : DiffPair_float_0 = DiffPair_float_0( d_2.y, s_diff_d_0.y );
    var _S259 : DiffPair_float_0 = DiffPair_float_0( _S257.primal_0, _S257.differential_0 );
    var _S260 : DiffPair_float_0 = s_fwd_angle_of_0(_S258, _S259);
    var width_1 : f32 = f32(word_0(map_1));
    var _S261 : f32 = f32(word_0(map_1 + u32(1))) - 1.0f;
    var _S262 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( vec2<f32>(_S255.primal_0 * 0.15915493667125702f * width_1 - 0.5f, _S260.primal_0 * 0.31830987334251404f * _S261), vec2<f32>(_S255.differential_0 * 0.15915493667125702f * width_1, _S260.differential_0 * 0.31830987334251404f * _S261) );
    return _S262;
}

fn cell_pdf_0( map_2 : u32,  cell_0 : u32) -> f32
{
    return 0.00397887360304594f + 0.94999998807907104f * number_0(word_0(map_2 + u32(15)) + cell_0);
}

fn map_pdf_0( map_3 : u32,  direction_9 : vec3<f32>) -> f32
{
    if((word_0(map_3 + u32(13))) == u32(4294967295))
    {
        return 0.07957746833562851f;
    }
    var _S263 : vec2<f64> = vec2<f64>(map_place_0(map_3, direction_9));
    var width_2 : u32 = word_0(map_3);
    var column_0 : u32 = wrapped_0(floor_of_0(_S263.x), i32(width_2), u32(0));
    return cell_pdf_0(map_3, u32(clamp(floor_of_0(_S263.y), i32(0), i32(word_0(map_3 + u32(1))) - i32(2))) * width_2 + column_0);
}

fn chosen_interval_0( sums_1 : u32,  count_3 : u32,  u_5 : f64,  through_0 : ptr<function, f32>) -> u32
{
    var _S264 : u32 = count_3 - u32(1);
    var total_2 : f64 = precise_0(sums_1 + u32(2) * _S264);
    var target_0 : f64 = u_5 * total_2;
    var low_3 : u32 = u32(0);
    var high_0 : u32 = _S264;
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
        var sum_1 : f64 = precise_0(sums_1 + u32(2) * middle_1);
        var _S265 : bool;
        if(sum_1 <= target_0)
        {
            _S265 = sum_1 < total_2;
        }
        else
        {
            _S265 = false;
        }
        if(_S265)
        {
            low_3 = middle_1 + u32(1);
        }
        else
        {
            high_0 = middle_1;
        }
    }
    var below_2 : f64;
    if(low_3 > u32(0))
    {
        below_2 = precise_0(sums_1 + u32(2) * (low_3 - u32(1)));
    }
    else
    {
        below_2 = 0.0lf;
    }
    (*through_0) = clamp(f32((target_0 - below_2) / (precise_0(sums_1 + u32(2) * low_3) - below_2)), 0.0f, 1.0f);
    return low_3;
}

fn cell_direction_0( map_4 : u32,  column_1 : u32,  row_2 : u32,  along_1 : f32,  down_0 : f32) -> vec3<f32>
{
    var turns_0 : f32 = (f32(column_1) + 0.5f + along_1) / f32(word_0(map_4));
    var azimuth_0 : vec2<f32> = sine_cosine_0(6.28318548202514648f * (turns_0 - floor(turns_0 + 0.5f)));
    var last_0 : u32 = word_0(map_4 + u32(1)) - u32(1);
    var is_lower_0 : bool = (u32(2) * row_2) >= last_0;
    var rows_0 : vec2<f32>;
    if(is_lower_0)
    {
        var _S266 : u32 = last_0 - row_2;
        rows_0 = vec2<f32>(f32(_S266), f32(_S266 - u32(1)));
    }
    else
    {
        rows_0 = vec2<f32>(f32(row_2), f32(row_2 + u32(1)));
    }
    var _S267 : f32 = f32(last_0);
    var _S268 : f32 = sine_cosine_0(rows_0.x * (1.57079637050628662f / _S267)).x;
    var _S269 : f32 = sine_cosine_0(rows_0.y * (1.57079637050628662f / _S267)).x;
    var off_0 : f32 = 2.0f * mix(_S268 * _S268, _S269 * _S269, down_0);
    var sine_3 : f32 = sqrt(off_0 * (2.0f - off_0));
    var _S270 : f32 = azimuth_0.x * sine_3;
    var _S271 : f32;
    if(is_lower_0)
    {
        _S271 = off_0 - 1.0f;
    }
    else
    {
        _S271 = 1.0f - off_0;
    }
    var local_0 : vec3<f32> = vec3<f32>(_S270, _S271, - azimuth_0.y * sine_3);
    var _S272 : u32 = map_4 + u32(2);
    return vec3<f32>(dot(vector_at_0(_S272), local_0), dot(vector_at_0(_S272 + u32(3)), local_0), dot(vector_at_0(_S272 + u32(6)), local_0));
}

fn sample_map_0( map_5 : u32,  key_5 : vec2<u32>,  dimension_4 : u32,  pdf_1 : ptr<function, f32>) -> vec3<f32>
{
    var u_6 : f64 = precise_random_0(key_5, dimension_4);
    var rest_5 : f64 = u_6 * 20.0lf - 1.0lf;
    var _S273 : u32 = map_5 + u32(13);
    var is_black_1 : bool = (word_0(_S273)) == u32(4294967295);
    var _S274 : bool;
    if(is_black_1)
    {
        _S274 = true;
    }
    else
    {
        _S274 = rest_5 < 0.0lf;
    }
    if(_S274)
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
        var direction_10 : vec3<f32> = uniform_direction_0(vec2<f32>(f32(u_6) / share_0, random_0(key_5, dimension_4 + u32(1))));
        var _S275 : f32 = map_pdf_0(map_5, direction_10);
        (*pdf_1) = _S275;
        return direction_10;
    }
    var rest_6 : f64 = rest_5 / 19.0lf;
    var width_3 : u32 = word_0(map_5);
    var down_1 : f32;
    var row_3 : u32 = chosen_interval_0(word_0(_S273), word_0(map_5 + u32(1)) - u32(1), precise_random_0(key_5, dimension_4 + u32(1)), &(down_1));
    var along_2 : f32;
    var column_2 : u32 = chosen_interval_0(word_0(map_5 + u32(14)) + u32(2) * width_3 * row_3, width_3, rest_6, &(along_2));
    (*pdf_1) = cell_pdf_0(map_5, row_3 * width_3 + column_2);
    return cell_direction_0(map_5, column_2, row_3, along_2, down_1);
}

fn random_pair_0( key_6 : vec2<u32>,  dimension_5 : u32) -> vec2<f32>
{
    return vec2<f32>(random_0(key_6, dimension_5), random_0(key_6, dimension_5 + u32(1)));
}

fn sample_cosine_0( u_7 : vec2<f32>) -> vec3<f32>
{
    var _S276 : f32 = u_7.x;
    var turn_2 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_7.y) * vec2<f32>(sqrt(_S276));
    return vec3<f32>(turn_2.y, turn_2.x, sqrt(1.0f - _S276));
}

fn to_world_0( axes_3 : Axes_0,  v_7 : vec3<f32>) -> vec3<f32>
{
    return axes_3.s_0 * vec3<f32>(v_7.x) + axes_3.t_0 * vec3<f32>(v_7.y) + axes_3.n_1 * vec3<f32>(v_7.z);
}

struct LightSample_0
{
     direction_11 : vec3<f32>,
     wo_0 : vec3<f32>,
     way_0 : vec3<f64>,
     nearest_0 : f64,
     farthest_0 : f64,
     is_on_emitter_0 : bool,
     emitter_5 : u32,
     probability_1 : f32,
     pdf_2 : f32,
     distance_4 : f32,
     place_16 : Place_0,
     is_specular_0 : bool,
};

fn sample_emitter_0( vertex_1 : Vertex_0,  choice_5 : Choice_0,  key_7 : vec2<u32>,  first_4 : u32,  sample_0 : ptr<function, LightSample_0>) -> bool
{
    (*sample_0).is_on_emitter_0 = true;
    (*sample_0).is_specular_0 = false;
    (*sample_0).direction_11 = vertex_1.axes_1.n_1;
    (*sample_0).wo_0 = vec3<f32>(0.0f);
    (*sample_0).way_0 = vertex_1.surface_4.exact_0;
    (*sample_0).distance_4 = 0.0f;
    (*sample_0).pdf_2 = 0.0f;
    (*sample_0).place_16 = vertex_1.surface_4.place_3;
    (*sample_0).nearest_0 = limit_at_0(u32(2));
    (*sample_0).farthest_0 = limit_at_0(u32(1));
    var _S277 : f32 = random_0(key_7, first_4);
    var _S278 : f32 = (*sample_0).probability_1;
    var _S279 : u32 = chosen_emitter_0(choice_5, _S277, &(_S278));
    (*sample_0).probability_1 = _S278;
    (*sample_0).emitter_5 = _S279;
    if(_S278 == 0.0f)
    {
        return false;
    }
    var record_13 : u32 = emitter_record_0((*sample_0).emitter_5);
    if(is_area_0(record_13))
    {
        var point_1 : EmitterPoint_0 = area_point_0(record_13, vertex_1.surface_4, key_7, first_4 + u32(1));
        if(!((point_1.pdf_0) > 0.0f))
        {
            return false;
        }
        (*sample_0).pdf_2 = point_1.pdf_0;
        (*sample_0).place_16 = point_1.place_15;
        var _S280 : vec3<f64> = position_of_0(point_1.place_15) - vertex_1.surface_4.exact_0;
        (*sample_0).way_0 = _S280;
        var _S281 : vec3<f32> = vec3<f32>(_S280);
        var _S282 : f32 = length(_S281);
        (*sample_0).distance_4 = _S282;
        (*sample_0).direction_11 = _S281 / vec3<f32>(_S282);
        (*sample_0).nearest_0 = (*sample_0).nearest_0 / f64(_S282);
        (*sample_0).farthest_0 = limit_at_0(u32(3));
    }
    else
    {
        if(is_map_0(record_13))
        {
            var _S283 : u32 = word_0(record_13 + u32(1));
            var _S284 : u32 = first_4 + u32(1);
            var _S285 : f32 = (*sample_0).pdf_2;
            var _S286 : vec3<f32> = sample_map_0(_S283, key_7, _S284, &(_S285));
            (*sample_0).pdf_2 = _S285;
            (*sample_0).direction_11 = _S286;
        }
        else
        {
            var local_1 : vec3<f32> = sample_cosine_0(random_pair_0(key_7, first_4 + u32(1)));
            (*sample_0).direction_11 = normalize(to_world_0(vertex_1.axes_1, local_1));
            (*sample_0).pdf_2 = local_1.z * 0.31830987334251404f;
        }
        (*sample_0).way_0 = vec3<f64>((*sample_0).direction_11);
    }
    var _S287 : vec3<f32> = to_local_0(vertex_1.axes_1, (*sample_0).direction_11);
    (*sample_0).wo_0 = _S287;
    return (_S287.z) > 0.0f;
}

fn first_material_number_0( depth_2 : u32) -> u32
{
    return vertex_numbers_0(depth_2) + u32(3) * word_0(u32(2));
}

fn coat_eta_0( numbers_3 : Numbers_0) -> f32
{
    return luminance_0(numbers_3.eta_0) / luminance_0(numbers_3.k_0);
}

struct DiffPair_Numbers_0
{
     primal_0 : Numbers_0,
     differential_0 : Numbers_0,
};

fn s_fwd_coat_eta_0( dpnumbers_0 : DiffPair_Numbers_0) -> DiffPair_float_0
{
    var _S288 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpnumbers_0.primal_0.eta_0, dpnumbers_0.differential_0.eta_0 );
    var _S289 : DiffPair_float_0 = s_fwd_luminance_0(_S288);
    var _S290 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpnumbers_0.primal_0.k_0, dpnumbers_0.differential_0.k_0 );
    var _S291 : DiffPair_float_0 = s_fwd_luminance_0(_S290);
    var _S292 : DiffPair_float_0 = DiffPair_float_0( _S289.primal_0 / _S291.primal_0, (_S289.differential_0 * _S291.primal_0 - _S289.primal_0 * _S291.differential_0) / (_S291.primal_0 * _S291.primal_0) );
    return _S292;
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

fn s_fwd_fresnel_dielectric_0( dpcosine_0 : DiffPair_float_0,  dpeta_0 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S293 : f32 = dpeta_0.primal_0;
    var eta2_1 : f32 = _S293 * _S293;
    var _S294 : f32 = dpeta_0.differential_0 * dpeta_0.primal_0;
    var s_diff_eta2_0 : f32 = _S294 + _S294;
    var cos2_1 : f32 = dpcosine_0.primal_0 * dpcosine_0.primal_0;
    var _S295 : f32 = dpcosine_0.differential_0 * dpcosine_0.primal_0;
    var s_diff_cos2_0 : f32 = _S295 + _S295;
    var _S296 : f32 = dpeta_0.primal_0 - 1.0f;
    var _S297 : f32 = dpeta_0.primal_0 + 1.0f;
    var denser_1 : f32 = _S296 * _S297;
    var s_diff_denser_0 : f32 = dpeta_0.differential_0 * _S297 + dpeta_0.differential_0 * _S296;
    var squared_4 : f32 = denser_1 + cos2_1;
    var s_diff_squared_0 : f32 = s_diff_denser_0 + s_diff_cos2_0;
    if(squared_4 <= 0.0f)
    {
        var _S298 : DiffPair_float_0 = DiffPair_float_0( 1.0f, 0.0f );
        return _S298;
    }
    var _S299 : DiffPair_float_0 = DiffPair_float_0( squared_4, s_diff_squared_0 );
    var _S300 : DiffPair_float_0 = _d_sqrt_0(_S299);
    var s_sum_1 : f32 = dpcosine_0.primal_0 + _S300.primal_0;
    var p_sum_1 : f32 = eta2_1 * dpcosine_0.primal_0 + _S300.primal_0;
    var _S301 : f32 = s_sum_1 * s_sum_1;
    var _S302 : f32 = (dpcosine_0.differential_0 + _S300.differential_0) * s_sum_1;
    var senkrecht_1 : f32 = denser_1 / _S301;
    var _S303 : f32 = eta2_1 + 1.0f;
    var _S304 : f32 = _S303 * cos2_1 - 1.0f;
    var _S305 : f32 = denser_1 * _S304;
    var _S306 : f32 = p_sum_1 * p_sum_1;
    var _S307 : f32 = (s_diff_eta2_0 * dpcosine_0.primal_0 + dpcosine_0.differential_0 * eta2_1 + _S300.differential_0) * p_sum_1;
    var parallel_1 : f32 = _S305 / _S306;
    var _S308 : f32 = (s_diff_denser_0 * _S301 - denser_1 * (_S302 + _S302)) / (_S301 * _S301) * senkrecht_1;
    var _S309 : f32 = ((s_diff_denser_0 * _S304 + (s_diff_eta2_0 * cos2_1 + s_diff_cos2_0 * _S303) * denser_1) * _S306 - _S305 * (_S307 + _S307)) / (_S306 * _S306) * parallel_1;
    var _S310 : DiffPair_float_0 = DiffPair_float_0( 0.5f * (senkrecht_1 * senkrecht_1 + parallel_1 * parallel_1), (_S308 + _S308 + (_S309 + _S309)) * 0.5f );
    return _S310;
}

fn transmittance_0( lobe_3 : Lobe_0,  eta_2 : f32,  cosine_5 : f32) -> f32
{
    if((lobe_3.kind_1) == u32(3))
    {
        return 1.0f - fresnel_dielectric_0(cosine_5, eta_2);
    }
    var place_17 : f32 = cosine_5 * 63.0f;
    var _S311 : u32 = min(u32(place_17), u32(62));
    var at_22 : u32 = word_0(lobe_3.record_3 + u32(3)) + _S311;
    var here_0 : f32 = number_0(at_22);
    return here_0 + (number_0(at_22 + u32(1)) - here_0) * (place_17 - f32(_S311));
}

fn s_fwd_transmittance_0( lobe_4 : Lobe_0,  dpeta_1 : DiffPair_float_0,  dpcosine_1 : DiffPair_float_0) -> DiffPair_float_0
{
    if((lobe_4.kind_1) == u32(3))
    {
        var _S312 : DiffPair_float_0 = DiffPair_float_0( dpcosine_1.primal_0, dpcosine_1.differential_0 );
        var _S313 : DiffPair_float_0 = DiffPair_float_0( dpeta_1.primal_0, dpeta_1.differential_0 );
        var _S314 : DiffPair_float_0 = s_fwd_fresnel_dielectric_0(_S312, _S313);
        var _S315 : DiffPair_float_0 = DiffPair_float_0( 1.0f - _S314.primal_0, 0.0f - _S314.differential_0 );
        return _S315;
    }
    var place_18 : f32 = dpcosine_1.primal_0 * 63.0f;
    var _S316 : u32 = min(u32(place_18), u32(62));
    var at_23 : u32 = word_0(lobe_4.record_3 + u32(3)) + _S316;
    var here_1 : f32 = number_0(at_23);
    var _S317 : f32 = number_0(at_23 + u32(1)) - here_1;
    var _S318 : DiffPair_float_0 = DiffPair_float_0( here_1 + _S317 * (place_18 - f32(_S316)), dpcosine_1.differential_0 * 63.0f * _S317 );
    return _S318;
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

fn is_rough_0( lobe_5 : Lobe_0) -> bool
{
    var _S319 : bool;
    if((lobe_5.kind_1) == u32(2))
    {
        _S319 = true;
    }
    else
    {
        _S319 = (lobe_5.kind_1) == u32(4);
    }
    return _S319;
}

struct Microfacets_0
{
     distribution_1 : u32,
     alpha_1 : vec2<f32>,
};

fn facets_of_0( lobe_6 : Lobe_0,  numbers_5 : Numbers_0) -> Microfacets_0
{
    var facets_0 : Microfacets_0;
    facets_0.distribution_1 = lobe_6.distribution_0;
    facets_0.alpha_1 = max(numbers_5.alpha_0, vec2<f32>(0.00009999999747379f));
    return facets_0;
}

struct Microfacets_Differential_0
{
     alpha_2 : vec2<f32>,
};

struct DiffPair_Microfacets_0
{
     primal_0 : Microfacets_0,
     differential_0 : Microfacets_Differential_0,
};

fn s_fwd_facets_of_0( lobe_7 : Lobe_0,  dpnumbers_1 : DiffPair_Numbers_0) -> DiffPair_Microfacets_0
{
    var _S320 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( dpnumbers_1.primal_0.alpha_0, dpnumbers_1.differential_0.alpha_0 );
    var _S321 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( vec2<f32>(0.00009999999747379f), vec2<f32>(0.0f) );
    var _S322 : DiffPair_vectorx3Cfloatx2C2x3E_0 = _d_max_vector_0(_S320, _S321);
    var _S323 : Microfacets_0 = Microfacets_0( lobe_7.distribution_0, _S322.primal_0 );
    var _S324 : Microfacets_Differential_0 = Microfacets_Differential_0( _S322.differential_0 );
    var _S325 : DiffPair_Microfacets_0 = DiffPair_Microfacets_0( _S323, _S324 );
    return _S325;
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
    var _S326 : f32 = length(longer_0);
    view_2.length_0 = _S326;
    var longer_1 : vec3<f32> = longer_0 / vec3<f32>(_S326);
    var _S327 : vec2<f32> = longer_1.xy;
    var _S328 : f32 = length(_S327);
    view_2.sine_4 = _S328;
    view_2.cosine_6 = longer_1.z;
    var _S329 : vec2<f32>;
    if(_S328 > 0.0f)
    {
        _S329 = _S327 / vec2<f32>(view_2.sine_4);
    }
    else
    {
        _S329 = vec2<f32>(1.0f, 0.0f);
    }
    view_2.around_0 = _S329;
    return view_2;
}

fn ggx_normal_0( view_3 : Stretched_0,  u_8 : vec2<f32>) -> vec3<f32>
{
    var _S330 : f32 = u_8.x;
    var radius_2 : f32 = sqrt(_S330);
    var turn_3 : vec2<f32> = sine_cosine_0(6.28318548202514648f * u_8.y);
    var across_3 : f32 = radius_2 * turn_3.y;
    var along_3 : f32 = radius_2 * turn_3.x;
    var visible_0 : f32 = 0.5f * (1.0f + view_3.cosine_6);
    var hidden_0 : f32 = 1.0f - visible_0;
    var _S331 : f32 = 1.0f - _S330;
    var edge_0 : f32 = sqrt(_S331 + along_3 * along_3);
    var up_0 : f32 = hidden_0 * edge_0 + visible_0 * along_3;
    var from_top_0 : f32 = edge_0 - along_3;
    var from_bottom_0 : f32 = edge_0 + along_3;
    var from_top_1 : f32;
    var from_bottom_1 : f32;
    if(along_3 > 0.0f)
    {
        from_top_1 = _S331 / from_bottom_0;
        from_bottom_1 = from_bottom_0;
    }
    else
    {
        var _S332 : f32 = _S331 / from_top_0;
        from_top_1 = from_top_0;
        from_bottom_1 = _S332;
    }
    var towards_0 : f32 = sqrt(visible_0 * from_top_1 * (2.0f * hidden_0 * edge_0 + visible_0 * from_bottom_1));
    return vec3<f32>(towards_0 * view_3.sine_4 - up_0 * view_3.cosine_6, across_3, max(towards_0 * view_3.cosine_6 + up_0 * view_3.sine_4, 0.0f));
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

fn s_fwd_exponential_0( dpx_11 : DiffPair_float_0) -> DiffPair_float_0
{
    if((dpx_11.primal_0) < -87.0f)
    {
        var _S333 : DiffPair_float_0 = DiffPair_float_0( 0.0f, 0.0f );
        return _S333;
    }
    var power_1 : f32 = floor(dpx_11.primal_0 * 1.4426950216293335f + 0.5f);
    var r_1 : f32 = dpx_11.primal_0 - power_1 * 0.693359375f + power_1 * 0.00021219444170129f;
    var _S334 : f32 = 0.00019875691214111f * r_1 + 0.00139819993637502f;
    var _S335 : f32 = _S334 * r_1 + 0.00833345204591751f;
    var tail_1 : f32 = _S335 * r_1 + 0.04166579619050026f;
    var _S336 : f32 = tail_1 * r_1 + 0.1666666567325592f;
    var tail_2 : f32 = _S336 * r_1 + 0.5f;
    var _S337 : f32 = tail_2 * r_1;
    var _S338 : f32 = (bitcast<f32>(((u32(i32(power_1) + i32(127)) << (u32(23))))));
    var _S339 : DiffPair_float_0 = DiffPair_float_0( (_S337 * r_1 + r_1 + 1.0f) * _S338, ((((((dpx_11.differential_0 * 0.00019875691214111f * r_1 + dpx_11.differential_0 * _S334) * r_1 + dpx_11.differential_0 * _S335) * r_1 + dpx_11.differential_0 * tail_1) * r_1 + dpx_11.differential_0 * _S336) * r_1 + dpx_11.differential_0 * tail_2) * r_1 + dpx_11.differential_0 * _S337 + dpx_11.differential_0) * _S338 );
    return _S339;
}

fn error_function_plus_one_0( x_9 : f32) -> vec2<f32>
{
    var _S340 : f32 = min(abs(x_9), 6.0f);
    var gaussian_0 : f32 = exponential_0(- _S340 * _S340);
    var place_19 : f32 = (_S340 - 2.0f) / (_S340 + 2.0f);
    var complement_0 : f32 = gaussian_0 * (((((((((-0.00042725281673484f * place_19 - 0.00127731403335929f) * place_19 + 0.00131371302995831f) * place_19 + 0.008666617795825f) * place_19 - 0.00805134233087301f) * place_19 - 0.05421232059597969f) * place_19 + 0.1640533059835434f) * place_19 - 0.16603080928325653f) * place_19 - 0.09276388585567474f) * place_19 + 1.27697837352752686f) / (1.0f + 2.0f * _S340);
    var _S341 : f32;
    if(x_9 < 0.0f)
    {
        _S341 = complement_0;
    }
    else
    {
        _S341 = 2.0f - complement_0;
    }
    return vec2<f32>(_S341, 1.128379225730896f * gaussian_0);
}

fn error_function_changed_0( x_10 : DiffPair_float_0) -> DiffPair_vectorx3Cfloatx2C2x3E_0
{
    var both_0 : vec2<f32> = error_function_plus_one_0(x_10.primal_0);
    var _S342 : f32 = both_0.y;
    var _S343 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( both_0, vec2<f32>(_S342, -2.0f * x_10.primal_0 * _S342) * vec2<f32>(x_10.differential_0) );
    return _S343;
}

fn visible_over_cos_0( facets_2 : Microfacets_0,  w_4 : vec3<f32>) -> f32
{
    var stretched_1 : vec2<f32> = w_4.xy * facets_2.alpha_1;
    var spread2_0 : f32 = dot(stretched_1, stretched_1);
    var _S344 : f32 = w_4.z;
    var z2_1 : f32 = _S344 * _S344;
    if((facets_2.distribution_1) == u32(1))
    {
        return 2.0f / (_S344 + sqrt(z2_1 + spread2_0));
    }
    if(z2_1 >= (36.0f * spread2_0))
    {
        return 1.0f / _S344;
    }
    var spread_0 : f32 = sqrt(spread2_0);
    var both_1 : vec2<f32> = error_function_plus_one_0(_S344 / spread_0);
    return 2.0f / (_S344 * both_1.x + 0.5f * spread_0 * both_1.y);
}

fn s_fwd_visible_over_cos_0( dpfacets_0 : DiffPair_Microfacets_0,  dpw_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_float_0
{
    var _S345 : vec2<f32> = dpw_0.primal_0.xy;
    var _S346 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( _S345 * dpfacets_0.primal_0.alpha_1, dpw_0.differential_0.xy * dpfacets_0.primal_0.alpha_1 + dpfacets_0.differential_0.alpha_2 * _S345 );
    var _S347 : DiffPair_float_0 = _d_dot_0(_S346, _S346);
    var _S348 : f32 = dpw_0.primal_0.z;
    var _S349 : f32 = dpw_0.differential_0.z;
    var z2_2 : f32 = _S348 * _S348;
    var _S350 : f32 = _S349 * _S348;
    var s_diff_z2_0 : f32 = _S350 + _S350;
    if((dpfacets_0.primal_0.distribution_1) == u32(1))
    {
        var _S351 : DiffPair_float_0 = DiffPair_float_0( z2_2 + _S347.primal_0, s_diff_z2_0 + _S347.differential_0 );
        var _S352 : DiffPair_float_0 = _d_sqrt_0(_S351);
        var _S353 : f32 = _S348 + _S352.primal_0;
        var _S354 : DiffPair_float_0 = DiffPair_float_0( 2.0f / _S353, (0.0f - 2.0f * (_S349 + _S352.differential_0)) / (_S353 * _S353) );
        return _S354;
    }
    if(z2_2 >= (36.0f * _S347.primal_0))
    {
        var _S355 : DiffPair_float_0 = DiffPair_float_0( 1.0f / _S348, (0.0f - _S349) / z2_2 );
        return _S355;
    }
    var _S356 : DiffPair_float_0 = DiffPair_float_0( _S347.primal_0, _S347.differential_0 );
    var _S357 : DiffPair_float_0 = _d_sqrt_0(_S356);
    var _S358 : DiffPair_float_0 = DiffPair_float_0( _S348 / _S357.primal_0, (_S349 * _S357.primal_0 - _S348 * _S357.differential_0) / (_S357.primal_0 * _S357.primal_0) );
    var _S359 : DiffPair_vectorx3Cfloatx2C2x3E_0 = error_function_changed_0(_S358);
    var _S360 : f32 = _S359.primal_0.x;
    var _S361 : f32 = 0.5f * _S357.primal_0;
    var _S362 : f32 = _S359.primal_0.y;
    var _S363 : f32 = _S348 * _S360 + _S361 * _S362;
    var _S364 : DiffPair_float_0 = DiffPair_float_0( 2.0f / _S363, (0.0f - 2.0f * (_S349 * _S360 + _S359.differential_0.x * _S348 + (_S357.differential_0 * 0.5f * _S362 + _S359.differential_0.y * _S361))) / (_S363 * _S363) );
    return _S364;
}

fn logarithm_0( x_11 : f32) -> f32
{
    var bits_1 : u32 = (bitcast<u32>((x_11)));
    var power_2 : f32 = f32(i32((bits_1 >> (u32(23)))) - i32(126));
    var m_0 : f32 = (bitcast<f32>(((((bits_1 & (u32(8388607)))) | (u32(1056964608))))));
    var m_1 : f32;
    var power_3 : f32;
    if(m_0 < 0.70710676908493042f)
    {
        var power_4 : f32 = power_2 - 1.0f;
        m_1 = m_0 + m_0;
        power_3 = power_4;
    }
    else
    {
        m_1 = m_0;
        power_3 = power_2;
    }
    var m_2 : f32 = m_1 - 1.0f;
    var z_4 : f32 = m_2 * m_2;
    return m_2 + (((((((((0.07037683576345444f * m_2 - 0.11514610052108765f) * m_2 + 0.11676998436450958f) * m_2 - 0.12420140951871872f) * m_2 + 0.14249323308467865f) * m_2 - 0.16668057441711426f) * m_2 + 0.20000714063644409f) * m_2 - 0.24999994039535522f) * m_2 + 0.33333331346511841f) * m_2 * z_4 - 0.00021219444170129f * power_3 - 0.5f * z_4) + 0.693359375f * power_3;
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
    var _S365 : f32 = max(view_4.cosine_6, view_4.sine_4);
    var slope_0 : f32 = clamp(error_function_inverse_0(clamp(target_1 / _S365 - 1.0f, -0.99999994039535522f, 0.99999994039535522f)) + -0.5f * view_4.sine_4 / _S365, -6.0f, 0.5f * steepest_0);
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
        var both_2 : vec2<f32> = error_function_plus_one_0(slope_0);
        var _S366 : f32 = both_2.y;
        var error_0 : f32 = view_4.cosine_6 * both_2.x + 0.5f * view_4.sine_4 * _S366 - target_1;
        var own_2 : f32 = _S366 * (view_4.cosine_6 - slope_0 * view_4.sine_4);
        var bend_0 : f32 = -2.0f * slope_0 * own_2 - _S366 * view_4.sine_4;
        if(error_0 > 0.0f)
        {
            high_1 = slope_0;
        }
        else
        {
            low_4 = slope_0;
        }
        var next_0 : f32 = slope_0 - error_0 * own_2 / (own_2 * own_2 - 0.5f * error_0 * bend_0);
        var _S367 : bool;
        if(next_0 >= low_4)
        {
            _S367 = next_0 <= high_1;
        }
        else
        {
            _S367 = false;
        }
        var next_1 : f32;
        if(!_S367)
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
        var _S368 : u32 = step_0 + u32(1);
        slope_0 = next_1;
        step_0 = _S368;
    }
    return vec3<f32>(- slope_0, error_function_inverse_0(max(2.0f * u_9.y - 1.0f, -0.99999994039535522f)), 1.0f);
}

fn mirrored_at_facet_0( facets_3 : Microfacets_0,  wi_3 : vec3<f32>,  u_10 : vec2<f32>) -> vec3<f32>
{
    var view_5 : Stretched_0 = stretched_0(facets_3, wi_3);
    var normal_9 : vec3<f32>;
    if((facets_3.distribution_1) == u32(1))
    {
        normal_9 = ggx_normal_0(view_5, u_10);
    }
    else
    {
        normal_9 = beckmann_normal_0(view_5, visible_over_cos_0(facets_3, wi_3), u_10);
    }
    var _S369 : f32 = view_5.around_0.x;
    var _S370 : f32 = normal_9.x;
    var _S371 : f32 = view_5.around_0.y;
    var _S372 : f32 = normal_9.y;
    var normal_10 : vec3<f32> = normalize(vec3<f32>(vec2<f32>(_S369 * _S370 - _S371 * _S372, _S371 * _S370 + _S369 * _S372) * facets_3.alpha_1, normal_9.z));
    return normalize(normal_10 * vec3<f32>((2.0f * dot(wi_3, normal_10))) - wi_3);
}

struct Drawn_0
{
     wo_1 : vec3<f32>,
     is_specular_1 : bool,
     probability_2 : f32,
};

fn draw_0( lobe_8 : Lobe_0,  wi_4 : vec3<f32>,  choice_6 : f32,  u_11 : vec2<f32>) -> Drawn_0
{
    var _S373 : bool = (lobe_8.kind_1) == u32(0);
    var has_base_0 : bool;
    if(_S373)
    {
        has_base_0 = true;
    }
    else
    {
        has_base_0 = (lobe_8.kind_1) == u32(3);
    }
    if(has_base_0)
    {
        has_base_0 = true;
    }
    else
    {
        has_base_0 = (lobe_8.kind_1) == u32(4);
    }
    var of_base_1 : f32;
    if(_S373)
    {
        of_base_1 = 1.0f;
    }
    else
    {
        of_base_1 = 0.0f;
    }
    var _S374 : bool;
    if((lobe_8.kind_1) == u32(3))
    {
        _S374 = true;
    }
    else
    {
        _S374 = (lobe_8.kind_1) == u32(4);
    }
    if(_S374)
    {
        of_base_1 = base_probability_0(lobe_8.numbers_2, transmittance_0(lobe_8, coat_eta_0(lobe_8.numbers_2), wi_4.z));
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
        if(is_rough_0(lobe_8))
        {
            drawn_0.wo_1 = mirrored_at_facet_0(facets_of_0(lobe_8, lobe_8.numbers_2), wi_4, u_11);
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

fn sample_material_0( vertex_2 : Vertex_0,  key_8 : vec2<u32>,  first_5 : u32) -> LightSample_0
{
    var drawn_1 : Drawn_0 = draw_0(vertex_2.lobe_1, value_of_0(vertex_2.wi_1), random_0(key_8, first_5), random_pair_0(key_8, first_5 + u32(1)));
    var sample_1 : LightSample_0;
    sample_1.is_on_emitter_0 = false;
    sample_1.is_specular_0 = drawn_1.is_specular_1;
    sample_1.probability_1 = drawn_1.probability_2;
    sample_1.wo_0 = drawn_1.wo_1;
    var _S375 : vec3<f32> = normalize(to_world_0(vertex_2.axes_1, drawn_1.wo_1));
    sample_1.direction_11 = _S375;
    sample_1.way_0 = vec3<f64>(_S375);
    sample_1.nearest_0 = limit_at_0(u32(2));
    sample_1.farthest_0 = limit_at_0(u32(1));
    sample_1.emitter_5 = u32(4294967295);
    sample_1.distance_4 = 0.0f;
    sample_1.pdf_2 = 0.0f;
    sample_1.place_16 = vertex_2.surface_4.place_3;
    return sample_1;
}

fn walked_of_0( path_6 : Path_0) -> vec3<f32>
{
    return path_6.walked_0;
}

fn specular_direction_0( vertex_3 : Vertex_0,  direction_12 : vec3<f32>,  wo_2 : vec3<f32>) -> Vector_0
{
    var change_7 : vec3<f32> = change_of_0(vertex_3.wi_1);
    return changing_0(direction_12, to_world_0(vertex_3.axes_change_0, wo_2) + to_world_0(vertex_3.axes_1, vec3<f32>((vec2<f32>(0) - change_7.xy), change_7.z)));
}

fn s_fwd_fresnel_conductor_channel_0( dpcosine_2 : DiffPair_float_0,  dpeta_2 : DiffPair_float_0,  dpk_0 : DiffPair_float_0) -> DiffPair_float_0
{
    var _S376 : f32 = dpcosine_2.primal_0;
    var cos2_2 : f32 = _S376 * _S376;
    var _S377 : f32 = dpcosine_2.differential_0 * dpcosine_2.primal_0;
    var s_diff_cos2_1 : f32 = _S377 + _S377;
    var sin2_0 : f32 = 1.0f - cos2_2;
    var s_diff_sin2_0 : f32 = 0.0f - s_diff_cos2_1;
    var _S378 : f32 = dpeta_2.differential_0 * dpeta_2.primal_0;
    var _S379 : f32 = dpk_0.differential_0 * dpk_0.primal_0;
    var real_0 : f32 = dpeta_2.primal_0 * dpeta_2.primal_0 - dpk_0.primal_0 * dpk_0.primal_0 - sin2_0;
    var s_diff_real_0 : f32 = _S378 + _S378 - (_S379 + _S379) - s_diff_sin2_0;
    var product_1 : f32 = dpeta_2.primal_0 * dpk_0.primal_0;
    var s_diff_product_0 : f32 = dpeta_2.differential_0 * dpk_0.primal_0 + dpk_0.differential_0 * dpeta_2.primal_0;
    var _S380 : f32 = s_diff_real_0 * real_0;
    var _S381 : f32 = s_diff_product_0 * product_1;
    var _S382 : DiffPair_float_0 = DiffPair_float_0( real_0 * real_0 + 4.0f * (product_1 * product_1), _S380 + _S380 + (_S381 + _S381) * 4.0f );
    var _S383 : DiffPair_float_0 = _d_sqrt_0(_S382);
    if((_S383.primal_0) == 0.0f)
    {
        var _S384 : DiffPair_float_0 = DiffPair_float_0( 1.0f, 0.0f );
        return _S384;
    }
    var _S385 : DiffPair_float_0 = DiffPair_float_0( real_0, s_diff_real_0 );
    var _S386 : DiffPair_float_0 = _d_abs_0(_S385);
    var _S387 : DiffPair_float_0 = DiffPair_float_0( 0.5f * (_S383.primal_0 + _S386.primal_0), (_S383.differential_0 + _S386.differential_0) * 0.5f );
    var _S388 : DiffPair_float_0 = _d_sqrt_0(_S387);
    var smaller_0 : f32 = product_1 / _S388.primal_0;
    var s_diff_smaller_0 : f32 = (s_diff_product_0 * _S388.primal_0 - product_1 * _S388.differential_0) / (_S388.primal_0 * _S388.primal_0);
    var _S389 : bool = real_0 < 0.0f;
    var a_20 : f32;
    var s_diff_a_1 : f32;
    if(_S389)
    {
        a_20 = smaller_0;
        s_diff_a_1 = s_diff_smaller_0;
    }
    else
    {
        a_20 = _S388.primal_0;
        s_diff_a_1 = _S388.differential_0;
    }
    var b_14 : f32;
    var s_diff_b_1 : f32;
    if(_S389)
    {
        b_14 = _S388.primal_0;
        s_diff_b_1 = _S388.differential_0;
    }
    else
    {
        b_14 = smaller_0;
        s_diff_b_1 = s_diff_smaller_0;
    }
    var less_0 : f32 = a_20 - dpcosine_2.primal_0;
    var more_0 : f32 = a_20 + dpcosine_2.primal_0;
    var _S390 : f32 = (s_diff_a_1 - dpcosine_2.differential_0) * less_0;
    var _S391 : f32 = b_14 * b_14;
    var _S392 : f32 = s_diff_b_1 * b_14;
    var _S393 : f32 = _S392 + _S392;
    var _S394 : f32 = less_0 * less_0 + _S391;
    var _S395 : f32 = (s_diff_a_1 + dpcosine_2.differential_0) * more_0;
    var _S396 : f32 = more_0 * more_0 + _S391;
    var senkrecht_2 : f32 = _S394 / _S396;
    var _S397 : f32 = s_diff_sin2_0 * sin2_0;
    var p_sum_2 : f32 = _S383.primal_0 * cos2_2 + sin2_0 * sin2_0;
    var s_diff_p_sum_0 : f32 = _S383.differential_0 * cos2_2 + s_diff_cos2_1 * _S383.primal_0 + (_S397 + _S397);
    var _S398 : f32 = senkrecht_2 * p_sum_2;
    var _S399 : f32 = 2.0f * a_20;
    var _S400 : f32 = _S399 * dpcosine_2.primal_0;
    var _S401 : f32 = p_sum_2 + _S400 * sin2_0;
    var _S402 : DiffPair_float_0 = DiffPair_float_0( _S398 / _S401, ((((_S390 + _S390 + _S393) * _S396 - _S394 * (_S395 + _S395 + _S393)) / (_S396 * _S396) * p_sum_2 + s_diff_p_sum_0 * senkrecht_2) * _S401 - _S398 * (s_diff_p_sum_0 + ((s_diff_a_1 * 2.0f * dpcosine_2.primal_0 + dpcosine_2.differential_0 * _S399) * sin2_0 + s_diff_sin2_0 * _S400))) / (_S401 * _S401) );
    return _S402;
}

fn s_fwd_fresnel_conductor_0( dpcosine_3 : DiffPair_float_0,  dpeta_3 : DiffPair_vectorx3Cfloatx2C3x3E_0,  dpk_1 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var _S403 : DiffPair_float_0 = DiffPair_float_0( dpcosine_3.primal_0, dpcosine_3.differential_0 );
    var _S404 : DiffPair_float_0 = DiffPair_float_0( dpeta_3.primal_0.x, dpeta_3.differential_0.x );
    var _S405 : DiffPair_float_0 = DiffPair_float_0( dpk_1.primal_0.x, dpk_1.differential_0.x );
    var _S406 : DiffPair_float_0 = s_fwd_fresnel_conductor_channel_0(_S403, _S404, _S405);
    var _S407 : DiffPair_float_0 = DiffPair_float_0( dpeta_3.primal_0.y, dpeta_3.differential_0.y );
    var _S408 : DiffPair_float_0 = DiffPair_float_0( dpk_1.primal_0.y, dpk_1.differential_0.y );
    var _S409 : DiffPair_float_0 = s_fwd_fresnel_conductor_channel_0(_S403, _S407, _S408);
    var _S410 : DiffPair_float_0 = DiffPair_float_0( dpeta_3.primal_0.z, dpeta_3.differential_0.z );
    var _S411 : DiffPair_float_0 = DiffPair_float_0( dpk_1.primal_0.z, dpk_1.differential_0.z );
    var _S412 : DiffPair_float_0 = s_fwd_fresnel_conductor_channel_0(_S403, _S410, _S411);
    var _S413 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( vec3<f32>(_S406.primal_0, _S409.primal_0, _S412.primal_0), vec3<f32>(_S406.differential_0, _S409.differential_0, _S412.differential_0) );
    return _S413;
}

fn s_fwd_specular_fraction_0( lobe_9 : Lobe_0,  dpnumbers_2 : DiffPair_Numbers_0,  dpwi_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    if((lobe_9.kind_1) == u32(1))
    {
        var _S414 : DiffPair_float_0 = DiffPair_float_0( dpwi_0.primal_0.z, dpwi_0.differential_0.z );
        var _S415 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpnumbers_2.primal_0.eta_0, dpnumbers_2.differential_0.eta_0 );
        var _S416 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpnumbers_2.primal_0.k_0, dpnumbers_2.differential_0.k_0 );
        var _S417 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_fresnel_conductor_0(_S414, _S415, _S416);
        var _S418 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpnumbers_2.primal_0.specular_reflectance_0 * _S417.primal_0, dpnumbers_2.differential_0.specular_reflectance_0 * _S417.primal_0 + _S417.differential_0 * dpnumbers_2.primal_0.specular_reflectance_0 );
        return _S418;
    }
    var _S419 : DiffPair_Numbers_0 = DiffPair_Numbers_0( dpnumbers_2.primal_0, dpnumbers_2.differential_0 );
    var _S420 : DiffPair_float_0 = s_fwd_coat_eta_0(_S419);
    var _S421 : DiffPair_float_0 = DiffPair_float_0( dpwi_0.primal_0.z, dpwi_0.differential_0.z );
    var _S422 : DiffPair_float_0 = DiffPair_float_0( _S420.primal_0, _S420.differential_0 );
    var _S423 : DiffPair_float_0 = s_fwd_fresnel_dielectric_0(_S421, _S422);
    var _S424 : vec3<f32> = vec3<f32>(_S423.primal_0);
    var _S425 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpnumbers_2.primal_0.specular_reflectance_0 * _S424, dpnumbers_2.differential_0.specular_reflectance_0 * _S424 + vec3<f32>(_S423.differential_0) * dpnumbers_2.primal_0.specular_reflectance_0 );
    return _S425;
}

fn specular_0( lobe_10 : Lobe_0,  wi_5 : Vector_0) -> Vector_0
{
    var _S426 : DiffPair_Numbers_0 = DiffPair_Numbers_0( lobe_10.numbers_2, lobe_10.changes_0 );
    var _S427 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( wi_5.value_0, wi_5.change_0 );
    var _S428 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_specular_fraction_0(lobe_10, _S426, _S427);
    return changing_0(_S428.primal_0, _S428.differential_0);
}

fn turns_1( vertex_4 : Vertex_0) -> bool
{
    if((any(((vertex_4.surface_4.position_change_0) != vec3<f32>(0.0f)))))
    {
        return true;
    }
    return (change_word_0(u32(1))) != u32(0);
}

fn turning_0( vertex_5 : Vertex_0,  direction_13 : vec3<f32>) -> vec3<f32>
{
    var _S429 : vec3<f32>;
    if(turns_1(vertex_5))
    {
        _S429 = vertex_5.axes_change_0.n_1 * vec3<f32>(dot(vertex_5.axes_1.n_1, direction_13)) - vertex_5.axes_1.n_1 * vec3<f32>(dot(vertex_5.axes_change_0.n_1, direction_13));
    }
    else
    {
        _S429 = vec3<f32>(0.0f);
    }
    return _S429;
}

fn towards_emitter_0( vertex_6 : Vertex_0,  direction_14 : vec3<f32>,  record_14 : u32) -> Vector_0
{
    var _S430 : Vector_0;
    if((word_0(record_14)) == u32(1))
    {
        _S430 = changing_0(direction_14, turning_0(vertex_6, direction_14));
    }
    else
    {
        _S430 = still_0(direction_14);
    }
    return _S430;
}

fn turns_onward_0() -> bool
{
    return !walks_0();
}

fn local_change_0( vertex_7 : Vertex_0,  direction_15 : Vector_0) -> vec3<f32>
{
    return to_local_0(vertex_7.axes_change_0, value_of_0(direction_15)) + to_local_0(vertex_7.axes_1, change_of_0(direction_15));
}

struct Mirrored_0
{
     cosine_7 : f32,
     pdf_3 : f32,
     scattered_0 : f32,
};

struct DiffPair_Mirrored_0
{
     primal_0 : Mirrored_0,
     differential_0 : Mirrored_0,
};

fn s_fwd_Mirrored_x24init_0( dpcosine_4 : DiffPair_float_0,  dppdf_0 : DiffPair_float_0,  dpscattered_0 : DiffPair_float_0) -> DiffPair_Mirrored_0
{
    var _S431 : Mirrored_0 = Mirrored_0( dpcosine_4.primal_0, dppdf_0.primal_0, dpscattered_0.primal_0 );
    var _S432 : Mirrored_0 = Mirrored_0( dpcosine_4.differential_0, dppdf_0.differential_0, dpscattered_0.differential_0 );
    var _S433 : DiffPair_Mirrored_0 = DiffPair_Mirrored_0( _S431, _S432 );
    return _S433;
}

fn s_fwd_density_0( dpfacets_1 : DiffPair_Microfacets_0,  dpm_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_float_0
{
    var _S434 : f32 = dpm_0.primal_0.z;
    var _S435 : f32 = dpm_0.differential_0.z;
    if(_S434 <= 0.0f)
    {
        var _S436 : DiffPair_float_0 = DiffPair_float_0( 0.0f, 0.0f );
        return _S436;
    }
    var _S437 : f32 = 3.14159274101257324f * dpfacets_1.primal_0.alpha_1.x;
    var _S438 : f32 = dpfacets_1.primal_0.alpha_1.y;
    var scale_0 : f32 = _S437 * _S438;
    var s_diff_scale_0 : f32 = dpfacets_1.differential_0.alpha_2.x * 3.14159274101257324f * _S438 + dpfacets_1.differential_0.alpha_2.y * _S437;
    var _S439 : vec2<f32> = dpm_0.primal_0.xy;
    var _S440 : DiffPair_vectorx3Cfloatx2C2x3E_0 = DiffPair_vectorx3Cfloatx2C2x3E_0( _S439 / dpfacets_1.primal_0.alpha_1, (dpm_0.differential_0.xy * dpfacets_1.primal_0.alpha_1 - _S439 * dpfacets_1.differential_0.alpha_2) / (dpfacets_1.primal_0.alpha_1 * dpfacets_1.primal_0.alpha_1) );
    var _S441 : DiffPair_float_0 = _d_dot_0(_S440, _S440);
    var cos2_3 : f32 = _S434 * _S434;
    var _S442 : f32 = _S435 * _S434;
    var s_diff_cos2_2 : f32 = _S442 + _S442;
    if((dpfacets_1.primal_0.distribution_1) == u32(1))
    {
        var sum_2 : f32 = _S441.primal_0 + cos2_3;
        var s_diff_sum_0 : f32 = _S441.differential_0 + s_diff_cos2_2;
        var _S443 : f32 = scale_0 * sum_2;
        var _S444 : f32 = _S443 * sum_2;
        var _S445 : DiffPair_float_0 = DiffPair_float_0( 1.0f / _S444, (0.0f - ((s_diff_scale_0 * sum_2 + s_diff_sum_0 * scale_0) * sum_2 + s_diff_sum_0 * _S443)) / (_S444 * _S444) );
        return _S445;
    }
    var exponent_0 : f32 = _S441.primal_0 / cos2_3;
    var s_diff_exponent_0 : f32 = (_S441.differential_0 * cos2_3 - _S441.primal_0 * s_diff_cos2_2) / (cos2_3 * cos2_3);
    var _S446 : f32;
    var _S447 : f32;
    if(exponent_0 > 80.0f)
    {
        _S446 = 0.0f;
        _S447 = 0.0f;
    }
    else
    {
        var _S448 : DiffPair_float_0 = DiffPair_float_0( - exponent_0, - s_diff_exponent_0 );
        var _S449 : DiffPair_float_0 = s_fwd_exponential_0(_S448);
        var _S450 : f32 = scale_0 * cos2_3;
        var _S451 : f32 = _S450 * cos2_3;
        var _S452 : f32 = (_S449.differential_0 * _S451 - _S449.primal_0 * ((s_diff_scale_0 * cos2_3 + s_diff_cos2_2 * scale_0) * cos2_3 + s_diff_cos2_2 * _S450)) / (_S451 * _S451);
        _S446 = _S449.primal_0 / _S451;
        _S447 = _S452;
    }
    var _S453 : DiffPair_float_0 = DiffPair_float_0( _S446, _S447 );
    return _S453;
}

fn s_fwd_mirrored_0( dpfacets_2 : DiffPair_Microfacets_0,  dpwi_1 : DiffPair_vectorx3Cfloatx2C3x3E_0,  dpwo_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_Mirrored_0
{
    var _S454 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpwi_1.primal_0 + dpwo_0.primal_0, dpwi_1.differential_0 + dpwo_0.differential_0 );
    var _S455 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_normalize_impl_0(_S454);
    var _S456 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpwi_1.primal_0, dpwi_1.differential_0 );
    var _S457 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( _S455.primal_0, _S455.differential_0 );
    var _S458 : DiffPair_float_0 = _d_dot_1(_S456, _S457);
    var _S459 : DiffPair_Microfacets_0 = DiffPair_Microfacets_0( dpfacets_2.primal_0, dpfacets_2.differential_0 );
    var _S460 : DiffPair_float_0 = s_fwd_density_0(_S459, _S457);
    var _S461 : f32 = 0.25f * _S460.primal_0;
    var _S462 : DiffPair_float_0 = s_fwd_visible_over_cos_0(_S459, _S456);
    var _S463 : f32 = _S461 * _S462.primal_0;
    var _S464 : f32 = _S460.differential_0 * 0.25f * _S462.primal_0 + _S462.differential_0 * _S461;
    var _S465 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpwo_0.primal_0, dpwo_0.differential_0 );
    var _S466 : DiffPair_float_0 = s_fwd_visible_over_cos_0(_S459, _S465);
    var _S467 : f32 = _S463 * _S466.primal_0;
    var _S468 : f32 = dpwo_0.primal_0.z;
    var _S469 : Mirrored_0 = Mirrored_0( _S458.primal_0, _S463, _S467 * _S468 );
    var _S470 : Mirrored_0 = Mirrored_0( _S458.differential_0, _S464, (_S464 * _S466.primal_0 + _S466.differential_0 * _S463) * _S468 + dpwo_0.differential_0.z * _S467 );
    var _S471 : DiffPair_Mirrored_0 = DiffPair_Mirrored_0( _S469, _S470 );
    return _S471;
}

fn s_fwd_fresnel_diffuse_0( dpeta_4 : DiffPair_float_0) -> DiffPair_float_0
{
    var inverse_0 : f32 = 1.0f / dpeta_4.primal_0;
    var s_diff_inverse_0 : f32 = (0.0f - dpeta_4.differential_0) / (dpeta_4.primal_0 * dpeta_4.primal_0);
    if((dpeta_4.primal_0) < 1.0f)
    {
        var _S472 : f32 = -1.43990004062652588f * dpeta_4.primal_0 + 0.70990002155303955f;
        var _S473 : DiffPair_float_0 = DiffPair_float_0( _S472 * dpeta_4.primal_0 + 0.66809999942779541f + 0.06360000371932983f * inverse_0, dpeta_4.differential_0 * -1.43990004062652588f * dpeta_4.primal_0 + dpeta_4.differential_0 * _S472 + s_diff_inverse_0 * 0.06360000371932983f );
        return _S473;
    }
    var _S474 : f32 = -1.36881005764007568f * inverse_0 + 4.98553991317749023f;
    var _S475 : f32 = _S474 * inverse_0 - 7.80988979339599609f;
    var sum_3 : f32 = _S475 * inverse_0 + 6.75334978103637695f;
    var _S476 : f32 = sum_3 * inverse_0 - 3.47930002212524414f;
    var _S477 : DiffPair_float_0 = DiffPair_float_0( _S476 * inverse_0 + 0.91931700706481934f, (((s_diff_inverse_0 * -1.36881005764007568f * inverse_0 + s_diff_inverse_0 * _S474) * inverse_0 + s_diff_inverse_0 * _S475) * inverse_0 + s_diff_inverse_0 * sum_3) * inverse_0 + s_diff_inverse_0 * _S476 );
    return _S477;
}

fn s_fwd_base_0( lobe_11 : Lobe_0,  dpeta_5 : DiffPair_float_0,  dpdiffuse_0 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_vectorx3Cfloatx2C3x3E_0
{
    var internal_reflectance_0 : f32;
    var s_diff_internal_reflectance_0 : f32;
    if((lobe_11.kind_1) == u32(3))
    {
        var _S478 : DiffPair_float_0 = DiffPair_float_0( 1.0f / dpeta_5.primal_0, (0.0f - dpeta_5.differential_0) / (dpeta_5.primal_0 * dpeta_5.primal_0) );
        var _S479 : DiffPair_float_0 = s_fwd_fresnel_diffuse_0(_S478);
        internal_reflectance_0 = _S479.primal_0;
        s_diff_internal_reflectance_0 = _S479.differential_0;
    }
    else
    {
        internal_reflectance_0 = number_0(word_0(lobe_11.record_3 + u32(3)) + u32(64));
        s_diff_internal_reflectance_0 = 0.0f;
    }
    if((word_0(lobe_11.record_3 + u32(2))) == u32(0))
    {
        var _S480 : f32 = 1.0f - internal_reflectance_0;
        var _S481 : vec3<f32> = vec3<f32>((1.0f / _S480));
        var _S482 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpdiffuse_0.primal_0 * _S481, dpdiffuse_0.differential_0 * _S481 + vec3<f32>(((0.0f - (0.0f - s_diff_internal_reflectance_0)) / (_S480 * _S480))) * dpdiffuse_0.primal_0 );
        return _S482;
    }
    var _S483 : vec3<f32> = vec3<f32>(1.0f) - dpdiffuse_0.primal_0 * vec3<f32>(internal_reflectance_0);
    var _S484 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpdiffuse_0.primal_0 / _S483, (dpdiffuse_0.differential_0 * _S483 - dpdiffuse_0.primal_0 * (vec3<f32>(0.0f) - (dpdiffuse_0.differential_0 * vec3<f32>(internal_reflectance_0) + vec3<f32>(s_diff_internal_reflectance_0) * dpdiffuse_0.primal_0))) / (_S483 * _S483) );
    return _S484;
}

struct Scattering_0
{
     value_9 : vec3<f32>,
     pdf_4 : f32,
};

struct Scattering_Differential_0
{
     value_10 : vec3<f32>,
};

struct DiffPair_Scattering_0
{
     primal_0 : Scattering_0,
     differential_0 : Scattering_Differential_0,
};

fn s_fwd_scattering_0( lobe_12 : Lobe_0,  dpnumbers_3 : DiffPair_Numbers_0,  dpwi_2 : DiffPair_vectorx3Cfloatx2C3x3E_0,  dpwo_1 : DiffPair_vectorx3Cfloatx2C3x3E_0) -> DiffPair_Scattering_0
{
    var _S485 : f32 = dpwo_1.primal_0.z;
    var _S486 : f32 = dpwo_1.differential_0.z;
    var by_cosine_0 : f32 = _S485 * 0.31830987334251404f;
    var _S487 : f32 = _S486 * 0.31830987334251404f;
    if((lobe_12.kind_1) == u32(0))
    {
        var _S488 : vec3<f32> = vec3<f32>(by_cosine_0);
        var _S489 : Scattering_0 = Scattering_0( dpnumbers_3.primal_0.diffuse_reflectance_0 * _S488, by_cosine_0 );
        var _S490 : Scattering_Differential_0 = Scattering_Differential_0( dpnumbers_3.differential_0.diffuse_reflectance_0 * _S488 + vec3<f32>(_S487) * dpnumbers_3.primal_0.diffuse_reflectance_0 );
        var _S491 : DiffPair_Scattering_0 = DiffPair_Scattering_0( _S489, _S490 );
        return _S491;
    }
    var _S492 : DiffPair_float_0 = DiffPair_float_0( 0.0f, 0.0f );
    var _S493 : DiffPair_Mirrored_0 = s_fwd_Mirrored_x24init_0(_S492, _S492, _S492);
    var by_facets_0 : Mirrored_0;
    var s_diff_by_facets_0 : Mirrored_0;
    if(is_rough_0(lobe_12))
    {
        var _S494 : DiffPair_Numbers_0 = DiffPair_Numbers_0( dpnumbers_3.primal_0, dpnumbers_3.differential_0 );
        var _S495 : DiffPair_Microfacets_0 = s_fwd_facets_of_0(lobe_12, _S494);
        var _S496 : DiffPair_Microfacets_0 = DiffPair_Microfacets_0( _S495.primal_0, _S495.differential_0 );
        var _S497 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpwi_2.primal_0, dpwi_2.differential_0 );
        var _S498 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpwo_1.primal_0, dpwo_1.differential_0 );
        var _S499 : DiffPair_Mirrored_0 = s_fwd_mirrored_0(_S496, _S497, _S498);
        by_facets_0 = _S499.primal_0;
        s_diff_by_facets_0 = _S499.differential_0;
    }
    else
    {
        by_facets_0 = _S493.primal_0;
        s_diff_by_facets_0 = _S493.differential_0;
    }
    if((lobe_12.kind_1) == u32(2))
    {
        var _S500 : DiffPair_float_0 = DiffPair_float_0( by_facets_0.cosine_7, s_diff_by_facets_0.cosine_7 );
        var _S501 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpnumbers_3.primal_0.eta_0, dpnumbers_3.differential_0.eta_0 );
        var _S502 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpnumbers_3.primal_0.k_0, dpnumbers_3.differential_0.k_0 );
        var _S503 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_fresnel_conductor_0(_S500, _S501, _S502);
        var _S504 : vec3<f32> = vec3<f32>(by_facets_0.scattered_0);
        var _S505 : vec3<f32> = _S503.primal_0 * _S504;
        var _S506 : Scattering_0 = Scattering_0( dpnumbers_3.primal_0.specular_reflectance_0 * _S505, by_facets_0.pdf_3 );
        var _S507 : Scattering_Differential_0 = Scattering_Differential_0( dpnumbers_3.differential_0.specular_reflectance_0 * _S505 + (_S503.differential_0 * _S504 + vec3<f32>(s_diff_by_facets_0.scattered_0) * _S503.primal_0) * dpnumbers_3.primal_0.specular_reflectance_0 );
        var _S508 : DiffPair_Scattering_0 = DiffPair_Scattering_0( _S506, _S507 );
        return _S508;
    }
    var _S509 : DiffPair_Numbers_0 = DiffPair_Numbers_0( dpnumbers_3.primal_0, dpnumbers_3.differential_0 );
    var _S510 : DiffPair_float_0 = s_fwd_coat_eta_0(_S509);
    var _S511 : DiffPair_float_0 = DiffPair_float_0( _S510.primal_0, _S510.differential_0 );
    var _S512 : DiffPair_float_0 = DiffPair_float_0( dpwi_2.primal_0.z, dpwi_2.differential_0.z );
    var _S513 : DiffPair_float_0 = s_fwd_transmittance_0(lobe_12, _S511, _S512);
    var _S514 : DiffPair_float_0 = DiffPair_float_0( _S485, _S486 );
    var _S515 : DiffPair_float_0 = s_fwd_transmittance_0(lobe_12, _S511, _S514);
    var _S516 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( dpnumbers_3.primal_0.diffuse_reflectance_0, dpnumbers_3.differential_0.diffuse_reflectance_0 );
    var _S517 : DiffPair_vectorx3Cfloatx2C3x3E_0 = s_fwd_base_0(lobe_12, _S511, _S516);
    var _S518 : f32 = _S513.primal_0 * _S515.primal_0;
    var _S519 : f32 = _S518 * by_cosine_0;
    var _S520 : f32 = _S510.primal_0 * _S510.primal_0;
    var _S521 : f32 = _S510.differential_0 * _S510.primal_0;
    var _S522 : vec3<f32> = vec3<f32>((_S519 / _S520));
    var _S523 : vec3<f32> = _S517.primal_0 * _S522;
    var _S524 : vec3<f32> = _S517.differential_0 * _S522 + vec3<f32>(((((_S513.differential_0 * _S515.primal_0 + _S515.differential_0 * _S513.primal_0) * by_cosine_0 + _S487 * _S518) * _S520 - _S519 * (_S521 + _S521)) / (_S520 * _S520))) * _S517.primal_0;
    var probability_3 : f32 = base_probability_0(dpnumbers_3.primal_0, _S513.primal_0);
    var _S525 : f32 = probability_3 * by_cosine_0;
    var scattering_0 : Scattering_0;
    var s_diff_scattering_0 : Scattering_Differential_0;
    if((lobe_12.kind_1) == u32(4))
    {
        var _S526 : DiffPair_float_0 = DiffPair_float_0( by_facets_0.cosine_7, s_diff_by_facets_0.cosine_7 );
        var _S527 : DiffPair_float_0 = s_fwd_fresnel_dielectric_0(_S526, _S511);
        var _S528 : vec3<f32> = vec3<f32>((_S527.primal_0 * by_facets_0.scattered_0));
        var _S529 : vec3<f32> = _S524 + (dpnumbers_3.differential_0.specular_reflectance_0 * _S528 + vec3<f32>((_S527.differential_0 * by_facets_0.scattered_0 + s_diff_by_facets_0.scattered_0 * _S527.primal_0)) * dpnumbers_3.primal_0.specular_reflectance_0);
        var _S530 : f32 = _S525 + (1.0f - probability_3) * by_facets_0.pdf_3;
        scattering_0.value_9 = _S523 + dpnumbers_3.primal_0.specular_reflectance_0 * _S528;
        scattering_0.pdf_4 = _S530;
        s_diff_scattering_0.value_10 = _S529;
    }
    else
    {
        scattering_0.value_9 = _S523;
        scattering_0.pdf_4 = _S525;
        s_diff_scattering_0.value_10 = _S524;
    }
    var _S531 : DiffPair_Scattering_0 = DiffPair_Scattering_0( scattering_0, s_diff_scattering_0 );
    return _S531;
}

struct Scattered_0
{
     value_11 : Vector_0,
     pdf_5 : f32,
};

fn eval_and_pdf_0( lobe_13 : Lobe_0,  wi_6 : Vector_0,  wo_3 : Vector_0) -> Scattered_0
{
    var scattered_1 : Scattered_0;
    scattered_1.value_11 = still_0(vec3<f32>(0.0f));
    scattered_1.pdf_5 = 0.0f;
    var _S532 : bool;
    if((value_of_0(wo_3).z) <= 0.0f)
    {
        _S532 = true;
    }
    else
    {
        _S532 = !has_smooth_0(lobe_13);
    }
    if(_S532)
    {
        return scattered_1;
    }
    var _S533 : DiffPair_Numbers_0 = DiffPair_Numbers_0( lobe_13.numbers_2, lobe_13.changes_0 );
    var _S534 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( wi_6.value_0, wi_6.change_0 );
    var _S535 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( wo_3.value_0, wo_3.change_0 );
    var _S536 : DiffPair_Scattering_0 = s_fwd_scattering_0(lobe_13, _S533, _S534, _S535);
    scattered_1.value_11 = changing_0(_S536.primal_0.value_9, _S536.differential_0.value_10);
    scattered_1.pdf_5 = _S536.primal_0.pdf_4;
    return scattered_1;
}

fn scattered_to_0( vertex_8 : Vertex_0,  wo_4 : vec3<f32>,  direction_16 : Vector_0) -> Scattered_0
{
    return eval_and_pdf_0(vertex_8.lobe_1, vertex_8.wi_1, changing_0(wo_4, local_change_0(vertex_8, direction_16)));
}

fn scattered_along_0( vertex_9 : Vertex_0,  sample_2 : LightSample_0,  walked_1 : vec3<f32>,  moving_0 : ptr<function, Vector_0>) -> Scattered_0
{
    if(sample_2.is_specular_0)
    {
        (*moving_0) = specular_direction_0(vertex_9, sample_2.direction_11, sample_2.wo_0);
        var scattered_2 : Scattered_0;
        scattered_2.value_11 = specular_0(vertex_9.lobe_1, vertex_9.wi_1);
        scattered_2.pdf_5 = sample_2.probability_1;
        return scattered_2;
    }
    if((sample_2.emitter_5) != u32(4294967295))
    {
        (*moving_0) = towards_emitter_0(vertex_9, sample_2.direction_11, emitter_record_0(sample_2.emitter_5));
    }
    else
    {
        var _S537 : vec3<f32>;
        if(turns_onward_0())
        {
            _S537 = turning_0(vertex_9, sample_2.direction_11);
        }
        else
        {
            _S537 = walked_1;
        }
        (*moving_0) = changing_0(sample_2.direction_11, _S537);
    }
    return scattered_to_0(vertex_9, sample_2.wo_0, (*moving_0));
}

fn component_0( v_8 : vec3<f64>,  axis_2 : u32) -> f64
{
    var _S538 : f64;
    if(axis_2 == u32(0))
    {
        _S538 = v_8.x;
    }
    else
    {
        if(axis_2 == u32(1))
        {
            _S538 = v_8.y;
        }
        else
        {
            _S538 = v_8.z;
        }
    }
    return _S538;
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
     largest_0 : f64,
};

fn ray_along_0( origin_1 : vec3<f64>,  direction_17 : vec3<f64>,  t_min_1 : f64,  t_max_1 : f64,  axes_4 : ptr<function, u32>) -> Ray_0
{
    var size_3 : vec3<f32> = abs(vec3<f32>(direction_17));
    var _S539 : f32 = size_3.x;
    var _S540 : f32 = size_3.y;
    var _S541 : bool;
    if(_S539 >= _S540)
    {
        _S541 = _S539 >= (size_3.z);
    }
    else
    {
        _S541 = false;
    }
    var _S542 : i32;
    if(_S541)
    {
        _S542 = i32(0);
    }
    else
    {
        if(_S540 >= (size_3.z))
        {
            _S542 = i32(1);
        }
        else
        {
            _S542 = i32(2);
        }
    }
    var z_5 : u32 = u32(_S542);
    var x_12 : u32 = (z_5 + u32(1)) % u32(3);
    var y_3 : u32 = (z_5 + u32(2)) % u32(3);
    (*axes_4) = (((x_12 | (((y_3 << (u32(2))))))) | (((z_5 << (u32(4))))));
    var ray_0 : Ray_0;
    ray_0.origin_0 = origin_1;
    var along_4 : f64 = component_0(direction_17, z_5);
    ray_0.inverse_z_0 = 1.0lf / along_4;
    ray_0.shear_x_0 = component_0(direction_17, x_12) / along_4;
    ray_0.shear_y_0 = component_0(direction_17, y_3) / along_4;
    ray_0.t_min_0 = t_min_1;
    ray_0.t_max_0 = t_max_1;
    ray_0.local_per_t_0 = abs(along_4);
    ray_0.enter_0 = 0.0lf;
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
     axes_5 : u32,
};

fn ray_bound_0( view_6 : RayView_0,  limit_1 : f32,  node_4 : u32,  slot_3 : u32) -> f32
{
    var _S543 : u32 = u32(14) * node_4 + slot_3 / u32(4);
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
        var _S544 : u32 = axis_3;
        var _S545 : u32 = _S543 + u32(2) * axis_3;
        var _S546 : u32 = slot_3 % u32(4);
        var low_5 : f32 = (bitcast<f32>((nodes_0[_S545][_S546])));
        var high_2 : f32 = (bitcast<f32>((nodes_0[_S545 + u32(6)][_S546])));
        var _S547 : bool = (view_6.inverse_1[axis_3]) < 0.0f;
        var _S548 : f32;
        if(_S547)
        {
            _S548 = high_2;
        }
        else
        {
            _S548 = low_5;
        }
        var _S549 : f32 = max(near_0, _S548 * view_6.inverse_1[_S544] - view_6.offset_near_0[axis_3]);
        var _S550 : f32;
        if(_S547)
        {
            _S550 = low_5;
        }
        else
        {
            _S550 = high_2;
        }
        var _S551 : f32 = min(far_0, _S550 * view_6.inverse_1[_S544] - view_6.offset_far_0[axis_3]);
        var _S552 : u32 = axis_3 + u32(1);
        near_0 = _S549;
        far_0 = _S551;
        axis_3 = _S552;
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
    var k_4 : u32 = u32(0);
    var order_0 : u32 = u32(0);
    for(;;)
    {
        if(k_4 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S553 : u32 = k_4;
        if((bounds_0[k_4]) > limit_2)
        {
            k_4 = k_4 + u32(1);
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
            var _S554 : u32 = j_0;
            var _S555 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S553]))
            {
                _S555 = true;
            }
            else
            {
                if((bounds_0[_S554]) == (bounds_0[_S553]))
                {
                    _S555 = j_0 < k_4;
                }
                else
                {
                    _S555 = false;
                }
            }
            if(_S555)
            {
                rank_0 = rank_0 + u32(1);
            }
            j_0 = j_0 + u32(1);
        }
        order_0 = (order_0 | ((((k_4 + u32(1)) << ((u32(4) * rank_0))))));
        k_4 = k_4 + u32(1);
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
        var _S556 : f32;
        if((ray_child_0(node_5, slot_4)) == u32(4294967295))
        {
            _S556 = 3.00000000549775576e+38f;
        }
        else
        {
            _S556 = ray_bound_0(view_7, limit_3, node_5, slot_4);
        }
        bounds_1[slot_4] = _S556;
        slot_4 = slot_4 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn rounded_0( product_2 : f64,  largest_1 : f64) -> f64
{
    return min(product_2, largest_1);
}

fn corner_3( ray_1 : Ray_0,  axes_6 : u32,  at_24 : u32) -> vec3<f64>
{
    var relative_0 : vec3<f64> = primitive_vector_0(at_24) - ray_1.origin_0;
    var z_6 : f64 = component_0(relative_0, (axes_6 >> (u32(4))));
    return vec3<f64>(component_0(relative_0, (axes_6 & (u32(3)))) - rounded_0(ray_1.shear_x_0 * z_6, ray_1.largest_0), component_0(relative_0, (((axes_6 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_1.shear_y_0 * z_6, ray_1.largest_0), z_6);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_3 : f64,
     v_9 : f64,
     w_8 : f64,
};

fn intersect_0( ray_2 : Ray_0,  axes_7 : u32,  at_25 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_3 = 0.0lf;
    crossing_0.v_9 = 0.0lf;
    crossing_0.w_8 = 0.0lf;
    var a_21 : vec3<f64> = corner_3(ray_2, axes_7, at_25);
    var b_15 : vec3<f64> = corner_3(ray_2, axes_7, at_25 + u32(3));
    var c_8 : vec3<f64> = corner_3(ray_2, axes_7, at_25 + u32(6));
    var _S557 : f64 = c_8.x;
    var _S558 : f64 = b_15.y;
    var cx_by_0 : f64 = rounded_0(_S557 * _S558, ray_2.largest_0);
    var _S559 : f64 = c_8.y;
    var _S560 : f64 = b_15.x;
    var cy_bx_0 : f64 = rounded_0(_S559 * _S560, ray_2.largest_0);
    var _S561 : f64 = a_21.x;
    var ax_cy_0 : f64 = rounded_0(_S561 * _S559, ray_2.largest_0);
    var _S562 : f64 = a_21.y;
    var ay_cx_0 : f64 = rounded_0(_S562 * _S557, ray_2.largest_0);
    var bx_ay_0 : f64 = rounded_0(_S560 * _S562, ray_2.largest_0);
    var by_ax_0 : f64 = rounded_0(_S558 * _S561, ray_2.largest_0);
    var u_12 : f64 = cx_by_0 - cy_bx_0;
    var v_10 : f64 = ax_cy_0 - ay_cx_0;
    var w_9 : f64 = bx_ay_0 - by_ax_0;
    var _S563 : f64 = min(min(u_12, v_10), w_9);
    var _S564 : f64 = max(max(u_12, v_10), w_9);
    var _S565 : bool;
    if(_S563 < 0.0lf)
    {
        _S565 = _S564 > 0.0lf;
    }
    else
    {
        _S565 = false;
    }
    if(_S565)
    {
        return crossing_0;
    }
    var determinant_0 : f64 = u_12 + v_10 + w_9;
    if(_S563 <= 0.0lf)
    {
        _S565 = _S564 >= 0.0lf;
    }
    else
    {
        _S565 = false;
    }
    if(_S565)
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
    var t_4 : f64 = (rounded_0(u_12 * a_21.z, ray_2.largest_0) + rounded_0(v_10 * b_15.z, ray_2.largest_0) + rounded_0(w_9 * c_8.z, ray_2.largest_0)) / determinant_0 * ray_2.inverse_z_0;
    if((ray_2.t_min_0) <= t_4)
    {
        _S565 = t_4 <= (ray_2.t_max_0);
    }
    else
    {
        _S565 = false;
    }
    crossing_0.is_hit_0 = _S565;
    crossing_0.t_3 = t_4;
    crossing_0.v_9 = v_10 / determinant_0;
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
     v_11 : f64,
     w_10 : f64,
};

fn first_found_0( view_8 : RayView_0,  ray_3 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S566 : bool;
    var found_3 : Found_0;
    found_3.face_7 = u32(4294967295);
    found_3.triangle_9 = u32(4294967295);
    found_3.v_11 = 0.0lf;
    found_3.w_10 = 0.0lf;
    if(!((view_8.limit_0) >= 0.0f))
    {
        return found_3;
    }
    var way_1 : array<vec2<u32>, i32(40)>;
    way_1[i32(0)] = vec2<u32>(u32(0), u32(0));
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
            way_1[level_0] = vec2<u32>(entered_0, crossed_0(view_8, limit_4, entered_0));
            is_new_1 = true;
            entered_1 = u32(4294967295);
        }
        else
        {
            is_new_1 = is_new_0;
            entered_1 = entered_0;
        }
        var here_2 : vec2<u32> = way_1[level_0];
        var _S567 : u32 = way_1[level_0].y;
        if(_S567 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S568 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S568;
            continue;
        }
        var slot_5 : u32 = ((_S567 & (u32(15)))) - u32(1);
        way_1[level_0][i32(1)] = (_S567 >> (u32(4)));
        var _S569 : bool;
        if(!is_new_1)
        {
            _S569 = (ray_bound_0(view_8, limit_4, here_2.x, slot_5)) > limit_4;
        }
        else
        {
            _S569 = false;
        }
        if(_S569)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_2.x, slot_5);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S570 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S570;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S571 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S572 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_3 : u32 = _S572;
        for(;;)
        {
            if(i_3 < _S571)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_3), view_8.axes_5, u32(9) * i_3);
            if(!crossing_1.is_hit_0)
            {
                i_3 = i_3 + u32(1);
                continue;
            }
            if((found_3.face_7) == u32(4294967295))
            {
                _S566 = true;
            }
            else
            {
                _S566 = (crossing_1.t_3) < ((*ray_3).t_max_0);
            }
            var _S573 : bool;
            if(_S566)
            {
                _S573 = true;
            }
            else
            {
                _S573 = (face_6(i_3)) < (found_3.face_7);
            }
            var limit_6 : f32;
            if(_S573)
            {
                found_3.face_7 = face_6(i_3);
                found_3.triangle_9 = i_3;
                (*ray_3).t_max_0 = crossing_1.t_3;
                found_3.v_11 = crossing_1.v_9;
                found_3.w_10 = crossing_1.w_8;
                limit_6 = min(limit_5, f32(crossing_1.t_3 * (*ray_3).local_per_t_0 - (*ray_3).enter_0) + 2.0f * view_8.margin_0);
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
            _S566 = (found_3.face_7) != u32(4294967295);
        }
        else
        {
            _S566 = false;
        }
        if(_S566)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_3;
}

fn cast_0( origin_2 : vec3<f64>,  direction_18 : vec3<f64>,  t_min_2 : f64,  t_max_2 : f64,  any_1 : bool,  t_5 : ptr<function, f32>) -> Found_0
{
    var view_9 : RayView_0;
    var _S574 : u32 = view_9.axes_5;
    var _S575 : Ray_0 = ray_along_0(origin_2, direction_18, t_min_2, t_max_2, &(_S574));
    view_9.axes_5 = _S574;
    var ray_4 : Ray_0 = _S575;
    var _S576 : vec3<f32> = vec3<f32>(direction_18 / vec3<f64>(ray_4.local_per_t_0));
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
        var _S577 : f32 = max(abs(_S576[axis_4]), 8.67361737988403547e-19f);
        var _S578 : f32;
        if((_S576[axis_4]) < 0.0f)
        {
            _S578 = -1.0f / _S577;
        }
        else
        {
            _S578 = 1.0f / _S577;
        }
        view_9.inverse_1[axis_4] = _S578;
        axis_4 = axis_4 + u32(1);
    }
    var offset_4 : vec3<f32> = vec3<f32>(origin_2) * view_9.inverse_1;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_9.inverse_1);
    view_9.offset_near_0 = offset_4 + wider_0;
    view_9.offset_far_0 = offset_4 - wider_0;
    view_9.limit_0 = min(f32(t_max_2 * ray_4.local_per_t_0), 8.0f) + 3.814697265625e-06f;
    view_9.margin_0 = 3.814697265625e-06f;
    var found_4 : Found_0 = first_found_0(view_9, &(ray_4), any_1);
    (*t_5) = f32(ray_4.t_max_0);
    return found_4;
}

fn place_of_0( found_5 : Found_0) -> Place_0
{
    return exact_place_0(found_5.triangle_9, found_5.v_11, found_5.w_10);
}

fn x2A_0( a_22 : Vector_0,  b_16 : f32) -> Vector_0
{
    var _S579 : vec3<f32> = vec3<f32>(b_16);
    return changing_0(a_22.value_0 * _S579, a_22.change_0 * _S579);
}

fn emitter_seen_0( found_6 : Found_0,  direction_19 : vec3<f32>) -> u32
{
    if((found_6.face_7) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_6 : u32 = word_0(shape_of_0(found_6.triangle_9) + u32(4));
    var _S580 : bool;
    if(emitter_6 != u32(4294967295))
    {
        _S580 = (dot(cross_of_0(found_6.triangle_9), direction_19)) < 0.0f;
    }
    else
    {
        _S580 = false;
    }
    var _S581 : u32;
    if(_S580)
    {
        _S581 = emitter_6;
    }
    else
    {
        _S581 = u32(4294967295);
    }
    return _S581;
}

fn area_pdf_0( record_15 : u32,  face_8 : u32,  from_2 : Surface_0,  direction_20 : vec3<f32>,  distance_5 : f32) -> f32
{
    var own_3 : f32;
    var rectangle_1 : u32 = word_0(record_15 + u32(4));
    if(rectangle_1 != u32(4294967295))
    {
        var _S582 : SeenRectangle_0 = seen_rectangle_0(rectangle_1, from_2.position_0);
        if(!((_S582.solid_angle_0) > 0.0f))
        {
            return 0.0f;
        }
        if((_S582.solid_angle_0) >= 0.00100000004749745f)
        {
            return 1.0f / _S582.solid_angle_0;
        }
    }
    var _S583 : u32 = word_0(word_0(record_15 + u32(7)) + face_8);
    var nodes_at_2 : u32 = word_0(record_15 + u32(5));
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
        var is_second_1 : bool = _S583 >= (word_0(nodes_at_2 + u32(17) * word_0(node_6 + u32(3))));
        if(is_second_1)
        {
            own_3 = shares_1.y;
        }
        else
        {
            own_3 = shares_1.x;
        }
        var chosen_3 : f32 = chosen_2 * own_3;
        var _S584 : i32;
        if(is_second_1)
        {
            _S584 = i32(3);
        }
        else
        {
            _S584 = i32(2);
        }
        node_6 = nodes_at_2 + u32(17) * word_0(node_6 + u32(_S584));
        chosen_2 = chosen_3;
    }
    var _S585 : u32 = word_0(record_15 + u32(6));
    var _S586 : u32 = word_0(node_6);
    own_3 = 0.0f;
    var k_5 : u32 = _S586;
    var total_3 : f32 = 0.0f;
    for(;;)
    {
        if(k_5 < (word_0(node_6 + u32(1))))
        {
        }
        else
        {
            break;
        }
        var angle_6 : f32 = face_solid_angle_0(record_15, word_0(_S585 + k_5), from_2.exact_0);
        var total_4 : f32 = total_3 + angle_6;
        if(k_5 == _S583)
        {
            own_3 = angle_6;
        }
        k_5 = k_5 + u32(1);
        total_3 = total_4;
    }
    if(!(own_3 > 0.0f))
    {
        return 0.0f;
    }
    return chosen_2 / total_3 * density_of_0(own_3, cross_of_0(emitter_triangle_0(record_15, face_8)), distance_5, direction_20);
}

fn emitter_pdf_0( emitter_7 : u32,  found_7 : Found_0,  vertex_10 : Vertex_0,  direction_21 : vec3<f32>,  t_6 : f32) -> f32
{
    var record_16 : u32 = emitter_record_0(emitter_7);
    if(is_map_0(record_16))
    {
        var _S587 : f32 = map_pdf_0(word_0(record_16 + u32(1)), direction_21);
        return _S587;
    }
    if(!is_area_0(record_16))
    {
        return max(dot(vertex_10.axes_1.n_1, direction_21), 0.0f) * 0.31830987334251404f;
    }
    return area_pdf_0(record_16, found_7.face_7 - word_0(record_16 + u32(3)), vertex_10.surface_4, direction_21, t_6);
}

fn drift_at_0( vertex_11 : Vertex_0,  direction_22 : Vector_0,  t_7 : f32) -> vec3<f32>
{
    return vertex_11.surface_4.position_change_0 + change_of_0(direction_22) * vec3<f32>(t_7);
}

fn met_0( vertex_12 : Vertex_0,  direction_23 : Vector_0,  t_8 : f32,  place_20 : Place_0) -> Place_0
{
    var _S588 : Place_0 = place_20;
    var unused_0 : vec3<f32>;
    move_place_0(&(_S588), &(unused_0), value_of_0(direction_23), drift_at_0(vertex_12, direction_23, t_8));
    return _S588;
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

fn in_map_0( map_6 : u32,  direction_24 : vec3<f32>) -> Lookup_0
{
    var _S589 : vec2<f64> = vec2<f64>(map_place_0(map_6, direction_24));
    var point_2 : Point_0;
    point_2.value_4 = _S589;
    point_2.by_first_1 = vec2<f32>(1.0f, 0.0f);
    point_2.by_second_1 = vec2<f32>(0.0f, 1.0f);
    var x_13 : i32 = floor_of_0(_S589.x);
    var y_4 : i32 = floor_of_0(_S589.y);
    var width_4 : i32 = i32(word_0(map_6));
    var height_1 : i32 = i32(word_0(map_6 + u32(1)));
    var left_1 : u32 = wrapped_0(x_13, width_4, u32(0));
    var right_1 : u32 = wrapped_0(x_13 + i32(1), width_4, u32(0));
    var _S590 : u32 = wrapped_0(y_4, height_1, u32(2));
    var _S591 : u32 = u32(width_4);
    var first_6 : u32 = _S590 * _S591;
    var _S592 : u32 = wrapped_0(y_4 + i32(1), height_1, u32(2));
    var second_2 : u32 = _S592 * _S591;
    return between_0(vec4<u32>(first_6 + left_1, first_6 + right_1, second_2 + left_1, second_2 + right_1), point_2);
}

fn x2A_1( a_23 : Vector_0,  b_17 : Vector_0) -> Vector_0
{
    return changing_0(a_23.value_0 * b_17.value_0, a_23.change_0 * b_17.value_0 + a_23.value_0 * b_17.change_0);
}

fn emitted_0( emitter_8 : u32,  place_21 : Place_0,  direction_25 : Vector_0) -> Vector_0
{
    var record_17 : u32 = emitter_record_0(emitter_8);
    var texture_7 : u32 = word_0(record_17 + u32(1));
    if(!is_map_0(record_17))
    {
        var _S593 : Vector_0 = shown_0(texture_7, place_21);
        return _S593;
    }
    var _S594 : DiffPair_vectorx3Cfloatx2C3x3E_0 = DiffPair_vectorx3Cfloatx2C3x3E_0( direction_25.value_0, direction_25.change_0 );
    var _S595 : DiffPair_vectorx3Cfloatx2C2x3E_0 = s_fwd_map_place_0(texture_7, _S594);
    var factor_0 : Vector_0 = looked_up_0(word_0(texture_7 + u32(12)), one_texel_0(u32(0)), vec2<f32>(0.0f));
    var _S596 : u32 = word_0(texture_7 + u32(11));
    var _S597 : Lookup_0 = in_map_0(texture_7, value_of_0(direction_25));
    return x2A_1(looked_up_0(_S596, _S597, _S595.differential_0), factor_0);
}

fn x2B_0( a_24 : Vector_0,  b_18 : Vector_0) -> Vector_0
{
    return changing_0(a_24.value_0 + b_18.value_0, a_24.change_0 + b_18.change_0);
}

fn take_further_0( path_7 : ptr<function, Path_0>,  reflected_1 : ptr<function, Reflected_0>,  importance_0 : vec3<f32>) -> bool
{
    var depth_3 : u32 = launch_0.depth_0;
    var _S598 : u32 = vertex_numbers_0(launch_0.depth_0);
    var incoming_0 : vec3<f32> = value_of_0((*path_7).direction_0);
    var surface_6 : Surface_0 = surface_at_0((*path_7).place_1, incoming_0);
    move_surface_0(&(surface_6), incoming_0, (*path_7).drift_0);
    var material_1 : u32 = material_of_0(surface_6);
    if(material_1 == u32(4294967295))
    {
        return false;
    }
    var vertex_13 : Vertex_0 = vertex_at_0(surface_6, material_1, (*path_7).direction_0);
    var emitter_samples_0 : u32 = word_0(u32(2));
    var _S599 : u32 = word_0(u32(3));
    var _S600 : bool = !reaches_0(depth_3 + u32(3));
    var goes_on_0 : bool;
    if(_S600)
    {
        goes_on_0 = (vertex_13.lobe_1.kind_1) == u32(0);
    }
    else
    {
        goes_on_0 = false;
    }
    if(goes_on_0)
    {
        goes_on_0 = is_sampled_well_0(surface_6.position_0);
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
        bsdf_samples_0 = _S599;
    }
    var on_emitters_0 : u32;
    if(has_smooth_0(vertex_13.lobe_1))
    {
        on_emitters_0 = emitter_samples_0;
    }
    else
    {
        on_emitters_0 = u32(0);
    }
    var _S601 : Choice_0 = choice_at_0(surface_6.position_0, vertex_13.axes_1.n_1, on_emitters_0 == u32(0));
    goes_on_0 = false;
    var next_2 : Place_0 = (*path_7).place_1;
    var next_direction_0 : Vector_0 = (*path_7).direction_0;
    var next_distance_0 : f32 = 0.0f;
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
        var goes_on_1 : bool;
        var next_3 : Place_0;
        var next_direction_1 : Vector_0;
        if(i_4 < on_emitters_0)
        {
            var _S602 : bool = sample_emitter_0(vertex_13, _S601, (*path_7).key_0, _S598 + u32(3) * i_4, &(sample_3));
            if(!_S602)
            {
                goes_on_1 = goes_on_0;
                next_3 = next_2;
                next_direction_1 = next_direction_0;
                var _S603 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_2 = next_3;
                next_direction_0 = next_direction_1;
                i_4 = _S603;
                continue;
            }
        }
        else
        {
            sample_3 = sample_material_0(vertex_13, (*path_7).key_0, first_material_number_0(depth_3) + u32(3) * (i_4 - on_emitters_0));
        }
        var moving_1 : Vector_0;
        var scattered_3 : Scattered_0 = scattered_along_0(vertex_13, sample_3, walked_of_0((*path_7)), &(moving_1));
        var _S604 : bool;
        if(!sample_3.is_on_emitter_0)
        {
            _S604 = !((scattered_3.pdf_5) > 0.0f);
        }
        else
        {
            _S604 = false;
        }
        if(_S604)
        {
            goes_on_1 = goes_on_0;
            next_3 = next_2;
            next_direction_1 = next_direction_0;
            var _S603 : u32 = i_4 + u32(1);
            goes_on_0 = goes_on_1;
            next_2 = next_3;
            next_direction_0 = next_direction_1;
            i_4 = _S603;
            continue;
        }
        var t_9 : f32;
        var found_8 : Found_0 = cast_0(surface_6.exact_0, sample_3.way_0, sample_3.nearest_0, sample_3.farthest_0, sample_3.is_on_emitter_0, &(t_9));
        var own_5 : f32;
        var other_1 : f32;
        var next_distance_1 : f32;
        var scattered_4 : Scattered_0;
        if(sample_3.is_on_emitter_0)
        {
            if((found_8.face_7) != u32(4294967295))
            {
                goes_on_1 = goes_on_0;
                next_3 = next_2;
                next_direction_1 = next_direction_0;
                var _S603 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_2 = next_3;
                next_direction_0 = next_direction_1;
                i_4 = _S603;
                continue;
            }
            var own_6 : f32 = f32(emitter_samples_0) * sample_3.probability_1 * sample_3.pdf_2;
            if(!(own_6 > 0.0f))
            {
                goes_on_1 = goes_on_0;
                next_3 = next_2;
                next_direction_1 = next_direction_0;
                var _S603 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_2 = next_3;
                next_direction_0 = next_direction_1;
                i_4 = _S603;
                continue;
            }
            var _S605 : f32 = f32(bsdf_samples_0) * scattered_3.pdf_5;
            own_5 = own_6;
            other_1 = _S605;
            scattered_4 = scattered_3;
            goes_on_1 = goes_on_0;
            next_3 = next_2;
            next_direction_1 = next_direction_0;
            next_distance_1 = next_distance_0;
        }
        else
        {
            if(i_4 == on_emitters_0)
            {
                var _S606 : bool = (found_8.face_7) != u32(4294967295);
                var _S607 : Place_0 = place_of_0(found_8);
                var _S608 : Vector_0 = moving_1;
                var _S609 : f32 = t_9;
                (*reflected_1).onward_0 = x2A_0(scattered_3.value_11, 1.0f / scattered_3.pdf_5);
                if(!sample_3.is_specular_0)
                {
                    (*reflected_1).onward_0.change_0 = (*reflected_1).onward_0.change_0 + (*reflected_1).onward_0.value_0 * vec3<f32>((*path_7).divergence_0);
                }
                goes_on_1 = _S606;
                next_3 = _S607;
                next_direction_1 = _S608;
                own_5 = _S609;
            }
            else
            {
                goes_on_1 = goes_on_0;
                next_3 = next_2;
                next_direction_1 = next_direction_0;
                own_5 = next_distance_0;
            }
            var _S610 : u32 = emitter_seen_0(found_8, sample_3.direction_11);
            sample_3.emitter_5 = _S610;
            if(_S610 == u32(4294967295))
            {
                next_distance_0 = own_5;
                var _S603 : u32 = i_4 + u32(1);
                goes_on_0 = goes_on_1;
                next_2 = next_3;
                next_direction_0 = next_direction_1;
                i_4 = _S603;
                continue;
            }
            sample_3.place_16 = place_of_0(found_8);
            sample_3.distance_4 = t_9;
            var _S611 : f32 = f32(bsdf_samples_0) * scattered_3.pdf_5;
            var _S612 : bool;
            if(!sample_3.is_specular_0)
            {
                _S612 = emitter_samples_0 != u32(0);
            }
            else
            {
                _S612 = false;
            }
            if(_S612)
            {
                var pdf_6 : f32 = emitter_pdf_0(sample_3.emitter_5, found_8, vertex_13, sample_3.direction_11, t_9);
                other_1 = f32(emitter_samples_0) * chance_of_0(sample_3.emitter_5, _S601) * pdf_6;
            }
            else
            {
                other_1 = 0.0f;
            }
            var _S613 : Scattered_0 = scattered_along_0(vertex_13, sample_3, (*path_7).walked_0, &(moving_1));
            var _S614 : f32 = own_5;
            own_5 = _S611;
            scattered_4 = _S613;
            next_distance_1 = _S614;
        }
        var place_22 : Place_0 = sample_3.place_16;
        var place_23 : Place_0;
        if(is_area_0(emitter_record_0(sample_3.emitter_5)))
        {
            place_23 = met_0(vertex_13, moving_1, sample_3.distance_4, place_22);
        }
        else
        {
            place_23 = place_22;
        }
        var weight_0 : f32 = weight_over_0(own_5, other_1);
        var _S615 : Vector_0 = emitted_0(sample_3.emitter_5, place_23, moving_1);
        (*reflected_1).direct_0 = x2B_0((*reflected_1).direct_0, x2A_1(scattered_4.value_11, x2A_0(_S615, weight_0)));
        next_distance_0 = next_distance_1;
        var _S603 : u32 = i_4 + u32(1);
        goes_on_0 = goes_on_1;
        next_2 = next_3;
        next_direction_0 = next_direction_1;
        i_4 = _S603;
    }
    if(_S600)
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
    var _S616 : f32 = max(max(throughput_1.x, throughput_1.y), throughput_1.z);
    var _S617 : u32 = depth_3 + u32(1);
    if(_S617 >= (word_0(u32(1))))
    {
        var survival_0 : f32 = clamp(_S616, 0.05000000074505806f, 0.94999998807907104f);
        if((random_0((*path_7).key_0, vertex_numbers_0(_S617) - u32(1))) >= survival_0)
        {
            return false;
        }
        (*reflected_1).onward_0 = x2A_0((*reflected_1).onward_0, 1.0f / survival_0);
    }
    (*path_7).place_1 = next_2;
    (*path_7).direction_0 = next_direction_0;
    (*path_7).drift_0 = drift_at_0(vertex_13, next_direction_0, next_distance_0);
    return true;
}

fn set_word_0( path_8 : u32,  which_6 : u32,  value_12 : u32)
{
    paths_0[which_6 * launch_0.room_0 + path_8] = value_12;
    return;
}

fn set_vector_0( path_9 : u32,  which_7 : ptr<function, u32>,  value_13 : vec3<f32>)
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
        set_word_0(path_9, (*which_7) + axis_5, (bitcast<u32>((value_13[axis_5]))));
        axis_5 = axis_5 + u32(1);
    }
    (*which_7) = (*which_7) + u32(3);
    return;
}

fn set_vector_1( path_10 : u32,  which_8 : ptr<function, u32>,  value_14 : vec3<f32>)
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
        set_word_0(path_10, (*which_8) + axis_6, (bitcast<u32>((value_14[axis_6]))));
        axis_6 = axis_6 + u32(1);
    }
    (*which_8) = (*which_8) + u32(3);
    return;
}

fn set_changing_0( path_11 : u32,  which_9 : ptr<function, u32>,  vector_4 : Vector_0)
{
    set_vector_1(path_11, &((*which_9)), value_of_0(vector_4));
    set_vector_1(path_11, &((*which_9)), change_of_0(vector_4));
    return;
}

fn set_place_0( path_12 : u32,  which_10 : ptr<function, u32>,  place_24 : Place_0)
{
    set_word_0(path_12, (*which_10), place_24.triangle_0);
    set_word_0(path_12, (*which_10) + u32(1), (bitcast<u32>((place_24.v_0))));
    set_word_0(path_12, (*which_10) + u32(2), (bitcast<u32>((place_24.w_0))));
    set_word_0(path_12, (*which_10) + u32(3), (bitcast<u32>((place_24.v_rest_0))));
    set_word_0(path_12, (*which_10) + u32(4), (bitcast<u32>((place_24.w_rest_0))));
    (*which_10) = (*which_10) + u32(5);
    return;
}

fn store_0( number_of_path_1 : u32,  path_13 : Path_0)
{
    var at_26 : u32 = u32(1);
    set_changing_0(number_of_path_1, &(at_26), path_13.light_0);
    set_changing_0(number_of_path_1, &(at_26), path_13.throughput_0);
    set_changing_0(number_of_path_1, &(at_26), path_13.direction_0);
    set_vector_0(number_of_path_1, &(at_26), path_13.drift_0);
    set_place_0(number_of_path_1, &(at_26), path_13.place_1);
    var _S618 : u32 = at_26 + u32(1);
    set_word_0(number_of_path_1, at_26, path_13.key_0.x);
    at_26 = _S618 + u32(1);
    set_word_0(number_of_path_1, _S618, path_13.key_0.y);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S619 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S620 : u32 = u32(2) + zero_0;
        _S619 = _S620;
        if(rounds_0 < _S620)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S619;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S621 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

fn take_thread_further_0( thread_0 : u32)
{
    var at_27 : u32 = launch_0.first_0 + thread_0;
    if(at_27 >= (launch_0.end_0))
    {
        return;
    }
    var number_of_path_2 : u32 = input_0[at_27];
    var path_14 : Path_0 = load_0(number_of_path_2);
    var reflected_2 : Reflected_0 = nothing_reflected_0();
    var goes_on_2 : bool = take_further_0(&(path_14), &(reflected_2), vec3<f32>(0.0f));
    path_14.light_0 = x2B_0(path_14.light_0, x2A_1(path_14.throughput_0, reflected_2.direct_0));
    path_14.throughput_0 = x2A_1(path_14.throughput_0, reflected_2.onward_0);
    store_0(number_of_path_2, path_14);
    var _S622 : u32;
    if(goes_on_2)
    {
        _S622 = number_of_path_2;
    }
    else
    {
        _S622 = u32(4294967295);
    }
    set_word_0(at_27, u32(0), _S622);
    check_loops_0();
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn go_on_forward(@builtin(global_invocation_id) thread_1 : vec3<u32>)
{
    take_thread_further_0(thread_1.x);
    return;
}
