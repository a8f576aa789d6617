// Compiled from reverse.slang by `cargo xtask kernels`. Not to be edited.
// compiler: Slang 2026.12 in slangpy 0.43.1
// source: 56d966057bf54911
// result: 4469d2ce8709b438

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

@binding(0) @group(0) var<storage, read> nodes_0 : array<vec4<u32>>;

@binding(1) @group(0) var<storage, read> leaf_starts_0 : array<u32>;

@binding(3) @group(0) var<storage, read> rough_0 : array<vec4<u32>>;

@binding(7) @group(0) var<storage, read_write> sums_0 : array<atomic<u32>>;

@binding(6) @group(0) var<storage, read_write> paths_0 : array<u32>;

struct s_bwdCallableCtx_sqrt_0
{
     _S1 : f32,
};

struct DiffPair_float_0
{
     primal_0 : f32,
     differential_0 : f32,
};

fn _d_sqrt_0( dpx_0 : ptr<function, DiffPair_float_0>,  dOut_0 : f32)
{
    var _S2 : f32 = 0.5f / sqrt(max(1.00000001168609742e-07f, (*dpx_0).primal_0)) * dOut_0;
    (*dpx_0).primal_0 = (*dpx_0).primal_0;
    (*dpx_0).differential_0 = _S2;
    return;
}

fn s_bwdProp_sqrt_0( ctx_0 : s_bwdCallableCtx_sqrt_0,  d_x_0 : ptr<function, f32>,  d_out_0 : f32)
{
    var _S3 : DiffPair_float_0;
    _S3.primal_0 = ctx_0._S1;
    _d_sqrt_0(&(_S3), d_out_0);
    (*d_x_0) = _S3.differential_0;
    return;
}

struct Tuple_0
{
     value0_0 : f32,
};

fn s_apply_max_0( x_0 : f32,  y_0 : f32) -> Tuple_0
{
    var _S4 : Tuple_0 = Tuple_0( max(x_0, y_0) );
    return _S4;
}

struct s_bwdCallableCtx_max_0
{
     _S5 : f32,
     _S6 : f32,
};

fn _d_max_0( dpx_1 : ptr<function, DiffPair_float_0>,  dpy_0 : ptr<function, DiffPair_float_0>,  dOut_1 : f32)
{
    var _S7 : DiffPair_float_0 = (*dpx_1);
    var _S8 : f32;
    if(((*dpx_1).primal_0) > ((*dpy_0).primal_0))
    {
        _S8 = dOut_1;
    }
    else
    {
        if(((*dpx_1).primal_0) < ((*dpy_0).primal_0))
        {
            _S8 = 0.0f;
        }
        else
        {
            _S8 = 0.5f * dOut_1;
        }
    }
    (*dpx_1).primal_0 = _S7.primal_0;
    (*dpx_1).differential_0 = _S8;
    var _S9 : DiffPair_float_0 = (*dpy_0);
    if(((*dpy_0).primal_0) > (_S7.primal_0))
    {
        _S8 = dOut_1;
    }
    else
    {
        if(((*dpy_0).primal_0) < ((*dpx_1).primal_0))
        {
            _S8 = 0.0f;
        }
        else
        {
            _S8 = 0.5f * dOut_1;
        }
    }
    (*dpy_0).primal_0 = _S9.primal_0;
    (*dpy_0).differential_0 = _S8;
    return;
}

fn s_bwdProp_max_0( ctx_1 : s_bwdCallableCtx_max_0,  d_x_1 : ptr<function, f32>,  d_y_0 : ptr<function, f32>,  d_out_1 : f32)
{
    var _S10 : DiffPair_float_0;
    _S10.primal_0 = ctx_1._S5;
    var _S11 : DiffPair_float_0;
    _S11.primal_0 = ctx_1._S6;
    _d_max_0(&(_S10), &(_S11), d_out_1);
    (*d_x_1) = _S10.differential_0;
    (*d_y_0) = _S11.differential_0;
    return;
}

struct Tuple_1
{
     value0_1 : f32,
};

fn s_apply_min_0( x_1 : f32,  y_1 : f32) -> Tuple_1
{
    var _S12 : Tuple_1 = Tuple_1( min(x_1, y_1) );
    return _S12;
}

struct s_bwdCallableCtx_min_0
{
     _S13 : f32,
     _S14 : f32,
};

fn _d_min_0( dpx_2 : ptr<function, DiffPair_float_0>,  dpy_1 : ptr<function, DiffPair_float_0>,  dOut_2 : f32)
{
    var _S15 : DiffPair_float_0 = (*dpx_2);
    var _S16 : f32;
    if(((*dpx_2).primal_0) < ((*dpy_1).primal_0))
    {
        _S16 = dOut_2;
    }
    else
    {
        if(((*dpx_2).primal_0) > ((*dpy_1).primal_0))
        {
            _S16 = 0.0f;
        }
        else
        {
            _S16 = 0.5f * dOut_2;
        }
    }
    (*dpx_2).primal_0 = _S15.primal_0;
    (*dpx_2).differential_0 = _S16;
    var _S17 : DiffPair_float_0 = (*dpy_1);
    if(((*dpy_1).primal_0) < (_S15.primal_0))
    {
        _S16 = dOut_2;
    }
    else
    {
        if(((*dpy_1).primal_0) > ((*dpx_2).primal_0))
        {
            _S16 = 0.0f;
        }
        else
        {
            _S16 = 0.5f * dOut_2;
        }
    }
    (*dpy_1).primal_0 = _S17.primal_0;
    (*dpy_1).differential_0 = _S16;
    return;
}

fn s_bwdProp_min_0( ctx_2 : s_bwdCallableCtx_min_0,  d_x_2 : ptr<function, f32>,  d_y_1 : ptr<function, f32>,  d_out_2 : f32)
{
    var _S18 : DiffPair_float_0;
    _S18.primal_0 = ctx_2._S13;
    var _S19 : DiffPair_float_0;
    _S19.primal_0 = ctx_2._S14;
    _d_min_0(&(_S18), &(_S19), d_out_2);
    (*d_x_2) = _S18.differential_0;
    (*d_y_1) = _S19.differential_0;
    return;
}

struct Tuple_2
{
     value0_2 : f32,
};

fn s_apply_abs_0( x_2 : f32) -> Tuple_2
{
    var _S20 : Tuple_2 = Tuple_2( abs(x_2) );
    return _S20;
}

struct s_bwdCallableCtx_abs_0
{
     _S21 : f32,
};

fn _d_abs_0( dpx_3 : ptr<function, DiffPair_float_0>,  dOut_3 : f32)
{
    var _S22 : f32 = select(select(-1.0f, 0.0f, ((*dpx_3).primal_0) == 0.0f), 1.0f, ((*dpx_3).primal_0) > 0.0f) * dOut_3;
    (*dpx_3).primal_0 = (*dpx_3).primal_0;
    (*dpx_3).differential_0 = _S22;
    return;
}

fn s_bwdProp_abs_0( ctx_3 : s_bwdCallableCtx_abs_0,  d_x_3 : ptr<function, f32>,  d_out_3 : f32)
{
    var _S23 : DiffPair_float_0;
    _S23.primal_0 = ctx_3._S21;
    _d_abs_0(&(_S23), d_out_3);
    (*d_x_3) = _S23.differential_0;
    return;
}

struct Tuple_3
{
     value0_3 : f32,
};

fn s_apply_length_0( x_3 : vec2<f32>) -> Tuple_3
{
    var _S24 : Tuple_3 = Tuple_3( length(x_3) );
    return _S24;
}

struct s_bwdCallableCtx_length_0
{
     _S25 : vec2<f32>,
};

struct DiffPair_vectorx3Cfloatx2C2x3E_0
{
     primal_0 : vec2<f32>,
     differential_0 : vec2<f32>,
};

struct s_paramCtx_s_bwdCallableCtx_length_impl_0
{
     value0_4 : vec2<f32>,
};

struct s_bwdCallableCtx_length_impl_0
{
     value0_5 : s_paramCtx_s_bwdCallableCtx_length_impl_0,
};

fn s_bwdProp_length_impl_0( _S26 : s_bwdCallableCtx_length_impl_0,  _S27 : ptr<function, vec2<f32>>,  _S28 : f32)
{
    var _S29 : f32 = _S26.value0_5.value0_4[i32(0)];
    var _S30 : f32 = _S26.value0_5.value0_4[i32(1)];
    var _S31 : s_bwdCallableCtx_sqrt_0;
    _S31._S1 = _S29 * _S29 + _S30 * _S30;
    var _S32 : f32 = 0.0f;
    s_bwdProp_sqrt_0(_S31, &(_S32), _S28);
    var _S33 : f32 = _S26.value0_5.value0_4[i32(1)] * _S32;
    var _S34 : f32 = _S33 + _S33;
    var _S35 : f32 = _S26.value0_5.value0_4[i32(0)] * _S32;
    var _S36 : f32 = _S35 + _S35;
    var _S37 : vec2<f32> = vec2<f32>(0.0f);
    _S37[i32(1)] = _S34;
    _S37[i32(0)] = _S36;
    (*_S27) = _S37;
    return;
}

fn _S38( _S39 : ptr<function, DiffPair_vectorx3Cfloatx2C2x3E_0>,  _S40 : f32)
{
    var _S41 : s_paramCtx_s_bwdCallableCtx_length_impl_0;
    _S41.value0_4 = (*_S39).primal_0;
    var _S42 : s_bwdCallableCtx_length_impl_0 = s_bwdCallableCtx_length_impl_0( _S41 );
    var _S43 : vec2<f32> = (*_S39).differential_0;
    s_bwdProp_length_impl_0(_S42, &(_S43), _S40);
    (*_S39).differential_0 = _S43;
    return;
}

fn s_bwdProp_length_0( ctx_4 : s_bwdCallableCtx_length_0,  d_x_4 : ptr<function, vec2<f32>>,  d_out_4 : f32)
{
    var _S44 : DiffPair_vectorx3Cfloatx2C2x3E_0;
    _S44.primal_0 = ctx_4._S25;
    _S38(&(_S44), d_out_4);
    (*d_x_4) = _S44.differential_0;
    return;
}

struct DiffPair_vectorx3Cfloatx2C3x3E_0
{
     primal_0 : vec3<f32>,
     differential_0 : vec3<f32>,
};

struct s_minCtx_s_bwdCallableCtx_map_place_0
{
     value0_6 : vec3<f32>,
     value1_0 : vec3<f32>,
     value2_0 : vec3<f32>,
     value3_0 : u32,
     value4_0 : u32,
};

struct Tuple_4
{
     value0_7 : vec2<f32>,
     value1_1 : s_minCtx_s_bwdCallableCtx_map_place_0,
};

fn number_0( at_0 : u32) -> f32
{
    return (bitcast<f32>((scene_0[at_0])));
}

fn vector_at_0( at_1 : u32) -> vec3<f32>
{
    return vec3<f32>(number_0(at_1), number_0(at_1 + u32(1)), number_0(at_1 + u32(2)));
}

struct Tuple_5
{
     value0_8 : f32,
};

fn s_apply_angle_of_0( _S45 : f32,  _S46 : f32) -> Tuple_5
{
    var _S47 : Tuple_2 = s_apply_abs_0(_S45);
    var _S48 : Tuple_2 = s_apply_abs_0(_S46);
    var _S49 : Tuple_1 = s_apply_min_0(_S47.value0_2, _S48.value0_2);
    var _S50 : Tuple_0 = s_apply_max_0(_S47.value0_2, _S48.value0_2);
    var is_steep_0 : bool = (_S49.value0_1) > (0.41421356797218323f * _S50.value0_0);
    var above_0 : f32;
    if(is_steep_0)
    {
        above_0 = _S49.value0_1 - _S50.value0_0;
    }
    else
    {
        above_0 = _S49.value0_1;
    }
    var below_0 : f32;
    if(is_steep_0)
    {
        below_0 = _S49.value0_1 + _S50.value0_0;
    }
    else
    {
        below_0 = _S50.value0_0;
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
    if((_S48.value0_2) > (_S47.value0_2))
    {
        angle_1 = 1.57079637050628662f - angle_1;
    }
    if(_S45 < 0.0f)
    {
        angle_1 = 3.14159274101257324f - angle_1;
    }
    if(_S46 < 0.0f)
    {
        above_0 = - angle_1;
    }
    else
    {
        above_0 = angle_1;
    }
    var _S51 : Tuple_5;
    _S51.value0_8 = above_0;
    return _S51;
}

fn word_0( at_2 : u32) -> u32
{
    return scene_0[at_2];
}

fn s_apply_map_place_0( map_0 : u32,  _S52 : vec3<f32>) -> Tuple_4
{
    var _S53 : vec3<f32> = vec3<f32>(0.0f);
    var _S54 : s_minCtx_s_bwdCallableCtx_map_place_0;
    _S54.value0_6 = _S53;
    _S54.value1_0 = _S53;
    _S54.value2_0 = _S53;
    _S54.value3_0 = u32(0);
    _S54.value4_0 = u32(0);
    var _S55 : u32 = map_0 + u32(2);
    var _S56 : vec3<f32> = vector_at_0(_S55);
    _S54.value0_6 = _S56;
    var _S57 : vec3<f32> = _S56 * vec3<f32>(_S52.x);
    var _S58 : vec3<f32> = vector_at_0(_S55 + u32(3));
    _S54.value1_0 = _S58;
    var _S59 : vec3<f32> = _S57 + _S58 * vec3<f32>(_S52.y);
    var _S60 : vec3<f32> = vector_at_0(_S55 + u32(6));
    _S54.value2_0 = _S60;
    var d_0 : vec3<f32> = _S59 + _S60 * vec3<f32>(_S52.z);
    var _S61 : Tuple_5 = s_apply_angle_of_0(- d_0.z, d_0.x);
    var _S62 : Tuple_5 = s_apply_angle_of_0(d_0.y, s_apply_length_0(d_0.xz).value0_3);
    var _S63 : u32 = word_0(map_0);
    _S54.value3_0 = _S63;
    var width_0 : f32 = f32(_S63);
    var _S64 : u32 = word_0(map_0 + u32(1));
    _S54.value4_0 = _S64;
    var _S65 : Tuple_4;
    _S65.value0_7 = vec2<f32>(_S61.value0_8 * 0.15915493667125702f * width_0 - 0.5f, _S62.value0_8 * 0.31830987334251404f * (f32(_S64) - 1.0f));
    _S65.value1_1 = _S54;
    return _S65;
}

struct s_paramCtx_s_bwdCallableCtx_map_place_0
{
     value0_9 : vec3<f32>,
};

struct s_bwdCallableCtx_map_place_0
{
     value0_10 : s_paramCtx_s_bwdCallableCtx_map_place_0,
     value1_2 : s_minCtx_s_bwdCallableCtx_map_place_0,
};

struct s_paramCtx_s_bwdCallableCtx_angle_of_0
{
     value0_11 : f32,
     value1_3 : f32,
};

struct s_bwdCallableCtx_angle_of_0
{
     value0_12 : s_paramCtx_s_bwdCallableCtx_angle_of_0,
};

fn s_bwdProp_angle_of_0( _S66 : s_bwdCallableCtx_angle_of_0,  _S67 : ptr<function, f32>,  _S68 : ptr<function, f32>,  _S69 : f32)
{
    var _S70 : Tuple_2 = s_apply_abs_0(_S66.value0_12.value0_11);
    var _S71 : s_bwdCallableCtx_abs_0;
    _S71._S21 = _S66.value0_12.value0_11;
    var _S72 : s_bwdCallableCtx_abs_0 = _S71;
    var _S73 : Tuple_2 = s_apply_abs_0(_S66.value0_12.value1_3);
    var _S74 : s_bwdCallableCtx_abs_0;
    _S74._S21 = _S66.value0_12.value1_3;
    var _S75 : s_bwdCallableCtx_abs_0 = _S74;
    var _S76 : Tuple_1 = s_apply_min_0(_S70.value0_2, _S73.value0_2);
    var _S77 : s_bwdCallableCtx_min_0;
    _S77._S13 = _S70.value0_2;
    _S77._S14 = _S73.value0_2;
    var _S78 : s_bwdCallableCtx_min_0 = _S77;
    var _S79 : Tuple_0 = s_apply_max_0(_S70.value0_2, _S73.value0_2);
    var _S80 : s_bwdCallableCtx_max_0;
    _S80._S5 = _S70.value0_2;
    _S80._S6 = _S73.value0_2;
    var _S81 : s_bwdCallableCtx_max_0 = _S80;
    var is_steep_1 : bool = (_S76.value0_1) > (0.41421356797218323f * _S79.value0_0);
    var above_1 : f32;
    if(is_steep_1)
    {
        above_1 = _S76.value0_1 - _S79.value0_0;
    }
    else
    {
        above_1 = _S76.value0_1;
    }
    var below_1 : f32;
    if(is_steep_1)
    {
        below_1 = _S76.value0_1 + _S79.value0_0;
    }
    else
    {
        below_1 = _S79.value0_0;
    }
    var _S82 : bool = below_1 > 0.0f;
    if(_S82)
    {
    }
    else
    {
        below_1 = 1.0f;
    }
    var t_1 : f32 = above_1 / below_1;
    var _S83 : f32 = below_1 * below_1;
    var z_1 : f32 = t_1 * t_1;
    var _S84 : f32 = 0.08053744584321976f * z_1 - 0.13877685368061066f;
    var _S85 : f32 = _S84 * z_1 + 0.19977711141109467f;
    var tail_0 : f32 = _S85 * z_1 - 0.33332949876785278f;
    var _S86 : f32 = tail_0 * z_1;
    var _S87 : bool = (_S73.value0_2) > (_S70.value0_2);
    var _S88 : bool = (_S66.value0_12.value0_11) < 0.0f;
    var _S89 : f32;
    if((_S66.value0_12.value1_3) < 0.0f)
    {
        _S89 = - _S69;
    }
    else
    {
        _S89 = _S69;
    }
    if(_S88)
    {
        _S89 = - _S89;
    }
    if(_S87)
    {
        _S89 = - _S89;
    }
    var _S90 : f32 = t_1 * _S89;
    var s_diff_tail_T_0 : f32 = z_1 * _S90;
    var _S91 : f32 = z_1 * s_diff_tail_T_0;
    var _S92 : f32 = t_1 * (tail_0 * _S90 + _S85 * s_diff_tail_T_0 + _S84 * _S91 + 0.08053744584321976f * (z_1 * _S91));
    var _S93 : f32 = (_S89 + _S86 * _S89 + _S92 + _S92) / _S83;
    var _S94 : f32 = above_1 * - _S93;
    var _S95 : f32 = below_1 * _S93;
    if(_S82)
    {
        above_1 = _S94;
    }
    else
    {
        above_1 = 0.0f;
    }
    if(is_steep_1)
    {
        below_1 = above_1;
    }
    else
    {
        below_1 = 0.0f;
    }
    if(is_steep_1)
    {
        var _S96 : f32 = _S95 + below_1;
        above_1 = - _S95 + above_1;
        below_1 = _S96;
    }
    else
    {
        below_1 = _S95 + below_1;
    }
    var _S97 : f32 = 0.0f;
    var _S98 : f32 = 0.0f;
    s_bwdProp_max_0(_S81, &(_S97), &(_S98), above_1);
    var _S99 : f32 = 0.0f;
    var _S100 : f32 = 0.0f;
    s_bwdProp_min_0(_S78, &(_S99), &(_S100), below_1);
    var _S101 : f32 = _S98 + _S100;
    var _S102 : f32 = 0.0f;
    s_bwdProp_abs_0(_S75, &(_S102), _S101);
    var _S103 : f32 = _S97 + _S99;
    var _S104 : f32 = 0.0f;
    s_bwdProp_abs_0(_S72, &(_S104), _S103);
    (*_S67) = _S104;
    (*_S68) = _S102;
    return;
}

fn s_bwdProp_map_place_0( _S105 : s_bwdCallableCtx_map_place_0,  _S106 : ptr<function, vec3<f32>>,  _S107 : vec2<f32>)
{
    var d_1 : vec3<f32> = _S105.value1_2.value0_6 * vec3<f32>(_S105.value0_10.value0_9.x) + _S105.value1_2.value1_0 * vec3<f32>(_S105.value0_10.value0_9.y) + _S105.value1_2.value2_0 * vec3<f32>(_S105.value0_10.value0_9.z);
    var _S108 : f32 = d_1.x;
    var _S109 : s_paramCtx_s_bwdCallableCtx_angle_of_0;
    _S109.value0_11 = - d_1.z;
    _S109.value1_3 = _S108;
    var _S110 : s_bwdCallableCtx_angle_of_0 = s_bwdCallableCtx_angle_of_0( _S109 );
    var _S111 : f32 = d_1.y;
    var _S112 : vec2<f32> = d_1.xz;
    var _S113 : Tuple_3 = s_apply_length_0(_S112);
    var _S114 : s_bwdCallableCtx_length_0;
    _S114._S25 = _S112;
    var _S115 : s_paramCtx_s_bwdCallableCtx_angle_of_0;
    _S115.value0_11 = _S111;
    _S115.value1_3 = _S113.value0_3;
    var _S116 : s_bwdCallableCtx_angle_of_0 = s_bwdCallableCtx_angle_of_0( _S115 );
    var _S117 : f32 = 0.31830987334251404f * ((f32(_S105.value1_2.value4_0) - 1.0f) * _S107[i32(1)]);
    var _S118 : f32 = 0.15915493667125702f * (f32(_S105.value1_2.value3_0) * _S107[i32(0)]);
    var _S119 : f32 = 0.0f;
    var _S120 : f32 = 0.0f;
    s_bwdProp_angle_of_0(_S116, &(_S119), &(_S120), _S117);
    var _S121 : vec2<f32> = vec2<f32>(0.0f);
    s_bwdProp_length_0(_S114, &(_S121), _S120);
    var _S122 : f32 = 0.0f;
    var _S123 : f32 = 0.0f;
    s_bwdProp_angle_of_0(_S110, &(_S122), &(_S123), _S118);
    var s_diff_d_T_0 : vec3<f32> = vec3<f32>(_S121[i32(0)] + _S123, _S119, _S121[i32(1)] + - _S122);
    var _S124 : vec3<f32> = _S105.value1_2.value2_0 * s_diff_d_T_0;
    var _S125 : vec3<f32> = _S105.value1_2.value1_0 * s_diff_d_T_0;
    var _S126 : vec3<f32> = _S105.value1_2.value0_6 * s_diff_d_T_0;
    (*_S106) = vec3<f32>(_S126[i32(0)] + _S126[i32(1)] + _S126[i32(2)], _S125[i32(0)] + _S125[i32(1)] + _S125[i32(2)], _S124[i32(0)] + _S124[i32(1)] + _S124[i32(2)]);
    return;
}

fn _S127( _S128 : u32,  _S129 : ptr<function, DiffPair_vectorx3Cfloatx2C3x3E_0>,  _S130 : vec2<f32>)
{
    var _S131 : Tuple_4 = s_apply_map_place_0(_S128, (*_S129).primal_0);
    var _S132 : s_paramCtx_s_bwdCallableCtx_map_place_0;
    _S132.value0_9 = (*_S129).primal_0;
    var _S133 : s_bwdCallableCtx_map_place_0 = s_bwdCallableCtx_map_place_0( _S132, _S131.value1_1 );
    var _S134 : vec3<f32> = (*_S129).differential_0;
    s_bwdProp_map_place_0(_S133, &(_S134), _S130);
    (*_S129).differential_0 = _S134;
    return;
}

fn camera_word_0( at_3 : u32) -> u32
{
    return word_0(word_0(u32(13)) + at_3);
}

fn plus_0( a_0 : vec2<u32>,  b_0 : vec2<u32>) -> vec2<u32>
{
    var _S135 : u32 = a_0.x;
    var low_0 : u32 = _S135 + b_0.x;
    var _S136 : u32 = a_0.y + b_0.y;
    var _S137 : i32;
    if(low_0 < _S135)
    {
        _S137 = i32(1);
    }
    else
    {
        _S137 = i32(0);
    }
    return vec2<u32>(low_0, _S136 + u32(_S137));
}

fn shifted_xor_0( x_4 : vec2<u32>,  by_0 : u32) -> vec2<u32>
{
    var _S138 : u32 = x_4.y;
    return (x_4 ^ (vec2<u32>(((((x_4.x) >> (by_0))) | (((_S138 << ((u32(32) - by_0)))))), (_S138 >> (by_0)))));
}

fn product_0( a_1 : u32,  b_1 : u32) -> vec2<u32>
{
    var a0_0 : u32 = (a_1 & (u32(65535)));
    var a1_0 : u32 = (a_1 >> (u32(16)));
    var b0_0 : u32 = (b_1 & (u32(65535)));
    var b1_0 : u32 = (b_1 >> (u32(16)));
    var low_1 : u32 = a0_0 * b0_0;
    var middle_0 : u32 = a1_0 * b0_0 + ((low_1 >> (u32(16))));
    var rest_0 : u32 = ((middle_0 & (u32(65535)))) + a0_0 * b1_0;
    return vec2<u32>((((rest_0 << (u32(16)))) | (((low_1 & (u32(65535)))))), a1_0 * b1_0 + ((middle_0 >> (u32(16)))) + ((rest_0 >> (u32(16)))));
}

fn times_0( a_2 : vec2<u32>,  b_2 : vec2<u32>) -> vec2<u32>
{
    var _S139 : u32 = a_2.x;
    var _S140 : u32 = b_2.x;
    var low_2 : vec2<u32> = product_0(_S139, _S140);
    return vec2<u32>(low_2.x, low_2.y + _S139 * b_2.y + a_2.y * _S140);
}

fn mix_0( x_5 : vec2<u32>) -> vec2<u32>
{
    return shifted_xor_0(times_0(shifted_xor_0(times_0(shifted_xor_0(x_5, u32(30)), vec2<u32>(u32(484763065), u32(3210233709))), u32(27)), vec2<u32>(u32(321982955), u32(2496678331))), u32(31));
}

fn key_of_sample_0( seed_0 : vec2<u32>,  pixel_0 : u32,  sample_0 : u32) -> vec2<u32>
{
    return mix_0(((mix_0((seed_0 ^ ((mix_0(plus_0(vec2<u32>(pixel_0, u32(0)), vec2<u32>(u32(2135587861), u32(2654435769))))))))) ^ ((times_0(vec2<u32>(sample_0, u32(0)), vec2<u32>(u32(2135587861), u32(2654435769)))))));
}

fn random_bits_0( key_0 : vec2<u32>,  dimension_0 : u32) -> vec2<u32>
{
    return mix_0(plus_0(key_0, times_0(vec2<u32>(dimension_0 + u32(1), u32(0)), vec2<u32>(u32(2135587861), u32(2654435769)))));
}

fn precise_random_0( key_1 : vec2<u32>,  dimension_1 : u32) -> f32
{
    return f32(((random_bits_0(key_1, dimension_1).y) >> (u32(8)))) / 4096.0f / 4096.0f;
}

fn camera_place_0( at_4 : u32) -> u32
{
    return word_0(u32(14)) + at_4;
}

fn camera_number_0( at_5 : u32) -> f32
{
    return primitives_0[camera_place_0(at_5)];
}

fn exponential_0( x_6 : f32) -> f32
{
    if(x_6 < -87.0f)
    {
        return 0.0f;
    }
    var power_0 : f32 = floor(x_6 * 1.4426950216293335f + 0.5f);
    var r_0 : f32 = x_6 - power_0 * 0.693359375f + power_0 * 0.00021219444170129f;
    return ((((((0.00019875691214111f * r_0 + 0.00139819993637502f) * r_0 + 0.00833345204591751f) * r_0 + 0.04166579619050026f) * r_0 + 0.1666666567325592f) * r_0 + 0.5f) * r_0 * r_0 + r_0 + 1.0f) * (bitcast<f32>(((u32(i32(power_0) + i32(127)) << (u32(23))))));
}

fn sine_cosine_0( angle_2 : f32) -> vec2<f32>
{
    var quarters_0 : f32 = floor(angle_2 * 0.63661974668502808f + 0.5f);
    var x_7 : f32 = angle_2 - quarters_0 * 1.5703125f - quarters_0 * 0.00048375129699707f - quarters_0 * 7.54979012640433211e-08f;
    var z_2 : f32 = x_7 * x_7;
    var sine_0 : f32 = ((-0.00019515295571182f * z_2 + 0.00833216123282909f) * z_2 - 0.16666655242443085f) * z_2 * x_7 + x_7;
    var cosine_0 : f32 = ((0.00002443315679557f * z_2 - 0.00138873164542019f) * z_2 + 0.04166664555668831f) * z_2 * z_2 - 0.5f * z_2 + 1.0f;
    var quarter_0 : i32 = (i32(quarters_0) & (i32(3)));
    var turned_0 : vec2<f32>;
    if(((quarter_0 & (i32(1)))) != i32(0))
    {
        turned_0 = vec2<f32>(cosine_0, - sine_0);
    }
    else
    {
        turned_0 = vec2<f32>(sine_0, cosine_0);
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

fn sinc_0( x_8 : f32) -> f32
{
    if((abs(x_8)) < 0.00009999999747379f)
    {
        return 1.0f;
    }
    var nearest_0 : f32 = floor(x_8 + 0.5f);
    var sine_1 : f32 = sine_cosine_0(3.14159274101257324f * (x_8 - nearest_0)).x;
    var _S141 : f32;
    if(((i32(nearest_0) & (i32(1)))) != i32(0))
    {
        _S141 = - sine_1;
    }
    else
    {
        _S141 = sine_1;
    }
    return _S141 / (3.14159274101257324f * x_8);
}

fn filter_at_0( x_9 : f32) -> f32
{
    var kind_0 : u32 = camera_word_0(u32(2));
    var first_1 : f32 = (bitcast<f32>((camera_word_0(u32(3)))));
    var second_0 : f32 = (bitcast<f32>((camera_word_0(u32(4)))));
    var size_0 : f32 = abs(x_9);
    if(kind_0 == u32(1))
    {
        return 1.0f - size_0 * first_1;
    }
    if(kind_0 == u32(2))
    {
        return exponential_0(x_9 * x_9 * first_1) - 0.00033546262420714f;
    }
    if(kind_0 != u32(3))
    {
        return sinc_0(x_9) * sinc_0(x_9 * first_1);
    }
    var six_0 : vec4<f32>;
    if(size_0 < 1.0f)
    {
        var _S142 : f32 = 6.0f * second_0;
        six_0 = vec4<f32>(6.0f - 2.0f * first_1, 0.0f, 12.0f * first_1 + _S142 - 18.0f, 12.0f - 9.0f * first_1 - _S142);
    }
    else
    {
        six_0 = vec4<f32>(8.0f * first_1 + 24.0f * second_0, -12.0f * first_1 - 48.0f * second_0, 6.0f * first_1 + 30.0f * second_0, - first_1 - 6.0f * second_0);
    }
    return (((six_0.w * size_0 + six_0.z) * size_0 + six_0.y) * size_0 + six_0.x) / 6.0f;
}

fn along_side_0( side_0 : u32,  u_0 : f32,  weight_0 : ptr<function, f32>) -> f32
{
    var table_0 : u32 = camera_word_0(u32(6) + side_0);
    var start_0 : f32 = camera_number_0(table_0);
    var width_1 : f32 = camera_number_0(table_0 + u32(1));
    if((camera_word_0(u32(2))) == u32(0))
    {
        return start_0 + u_0 * (width_1 * 32.0f);
    }
    var rest_1 : u32 = u32(16);
    var bin_0 : u32 = u32(0);
    for(;;)
    {
        if(rest_1 > u32(0))
        {
        }
        else
        {
            break;
        }
        if(u_0 >= (camera_number_0(table_0 + u32(3) + bin_0 + rest_1)))
        {
            bin_0 = bin_0 + rest_1;
        }
        rest_1 = rest_1 / u32(2);
    }
    var _S143 : u32 = table_0 + u32(3);
    var probability_0 : f32 = camera_number_0(_S143 + u32(32) + bin_0);
    var place_0 : f32 = start_0 + (f32(bin_0) + min((u_0 - camera_number_0(_S143 + bin_0)) / probability_0, 1.0f)) * width_1;
    (*weight_0) = (*weight_0) * (filter_at_0(place_0) * (camera_number_0(table_0 + u32(2)) / probability_0));
    return place_0;
}

fn random_0( key_2 : vec2<u32>,  dimension_2 : u32) -> f32
{
    return f32(((random_bits_0(key_2, dimension_2).y) >> (u32(8)))) * 5.9604644775390625e-08f;
}

struct CameraSample_0
{
     key_3 : vec2<u32>,
     pixel_1 : u32,
     x_10 : f32,
     y_2 : f32,
     lens_0 : vec2<f32>,
     weight_1 : f32,
};

fn camera_sample_0( number_of_path_0 : u32) -> CameraSample_0
{
    var number_1 : u32 = input_0[i32(2)] + number_of_path_0;
    var pixels_0 : u32 = camera_word_0(u32(1));
    var columns_0 : u32 = camera_word_0(u32(0));
    var drawn_0 : CameraSample_0;
    var _S144 : u32 = number_1 % pixels_0;
    drawn_0.pixel_1 = _S144;
    var _S145 : vec2<u32> = vec2<u32>(input_0[i32(0)], input_0[i32(1)]);
    var _S146 : u32 = input_0[i32(3)];
    var _S147 : u32 = number_1 / pixels_0;
    drawn_0.key_3 = key_of_sample_0(_S145, _S144, _S146 + _S147);
    drawn_0.weight_1 = 1.0f;
    var column_0 : u32 = drawn_0.pixel_1 % columns_0;
    var row_0 : u32 = drawn_0.pixel_1 / columns_0;
    var _S148 : f32 = precise_random_0(drawn_0.key_3, u32(0));
    var _S149 : f32 = drawn_0.weight_1;
    var x_11 : f32 = along_side_0(column_0, _S148, &(_S149));
    var _S150 : u32 = columns_0 + row_0;
    var _S151 : f32 = precise_random_0(drawn_0.key_3, u32(1));
    var _S152 : f32 = _S149;
    var y_3 : f32 = along_side_0(_S150, _S151, &(_S152));
    drawn_0.weight_1 = _S152;
    drawn_0.x_10 = camera_number_0(u32(30)) - f32(column_0) - x_11;
    drawn_0.y_2 = camera_number_0(u32(31)) - f32(row_0) - y_3;
    drawn_0.lens_0 = vec2<f32>(0.0f);
    if((camera_word_0(u32(5))) != u32(0))
    {
        drawn_0.lens_0 = sine_cosine_0(6.28318548202514648f * random_0(drawn_0.key_3, u32(4))).yx * vec2<f32>(sqrt(precise_random_0(drawn_0.key_3, u32(3))));
    }
    return drawn_0;
}

fn primitive_vector_0( at_6 : u32) -> vec3<f32>
{
    return vec3<f32>(primitives_0[at_6], primitives_0[at_6 + u32(1)], primitives_0[at_6 + u32(2)]);
}

fn of_sample_0( vectors_0 : u32,  drawn_1 : CameraSample_0) -> vec3<f32>
{
    var at_7 : u32 = camera_place_0(vectors_0);
    return primitive_vector_0(at_7) + primitive_vector_0(at_7 + u32(3)) * vec3<f32>(drawn_1.x_10) + primitive_vector_0(at_7 + u32(6)) * vec3<f32>(drawn_1.y_2) + primitive_vector_0(at_7 + u32(9)) * vec3<f32>(drawn_1.lens_0.x) + primitive_vector_0(at_7 + u32(12)) * vec3<f32>(drawn_1.lens_0.y);
}

fn component_0( v_0 : vec3<f32>,  axis_0 : u32) -> f32
{
    var _S153 : f32;
    if(axis_0 == u32(0))
    {
        _S153 = v_0.x;
    }
    else
    {
        if(axis_0 == u32(1))
        {
            _S153 = v_0.y;
        }
        else
        {
            _S153 = v_0.z;
        }
    }
    return _S153;
}

fn limit_at_0( which_0 : u32) -> f32
{
    return primitives_0[word_0(u32(15)) + which_0];
}

struct CameraRay_0
{
     start_1 : vec3<f32>,
     direction_0 : vec3<f32>,
     length_0 : f32,
     from_record_0 : f32,
     from_camera_0 : f32,
};

fn camera_ray_0( drawn_2 : CameraSample_0) -> CameraRay_0
{
    var to_depth_one_0 : vec3<f32> = of_sample_0(u32(0), drawn_2);
    var recorded_0 : vec3<f32> = of_sample_0(u32(15), drawn_2);
    var size_1 : f32 = sqrt(dot(to_depth_one_0, to_depth_one_0));
    var ray_0 : CameraRay_0;
    ray_0.direction_0 = to_depth_one_0 / vec3<f32>(size_1);
    var until_0 : f32 = camera_number_0(u32(33)) * size_1;
    var enter_0 : f32 = camera_number_0(u32(32)) * size_1;
    var exit_0 : f32 = until_0;
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
        var from_0 : f32 = component_0(recorded_0, axis_1);
        var speed_0 : f32 = component_0(ray_0.direction_0, axis_1);
        var ahead_0 : f32;
        if(speed_0 != 0.0f)
        {
            if(speed_0 < 0.0f)
            {
                ahead_0 = -1.00000095367431641f;
            }
            else
            {
                ahead_0 = 1.00000095367431641f;
            }
            var _S154 : f32 = min(exit_0, (ahead_0 - from_0) / speed_0);
            enter_0 = max(enter_0, (- ahead_0 - from_0) / speed_0);
            exit_0 = _S154;
        }
        else
        {
            if((abs(from_0)) > 1.00000095367431641f)
            {
                ahead_0 = - limit_at_0(u32(1));
            }
            else
            {
                ahead_0 = exit_0;
            }
            exit_0 = ahead_0;
        }
        axis_1 = axis_1 + u32(1);
    }
    var is_inside_0 : bool = enter_0 <= exit_0;
    if(!is_inside_0)
    {
        enter_0 = 0.0f;
    }
    ray_0.start_1 = recorded_0 + ray_0.direction_0 * vec3<f32>(enter_0);
    if(is_inside_0)
    {
        exit_0 = until_0 - enter_0;
    }
    else
    {
        exit_0 = -1.0f;
    }
    ray_0.length_0 = exit_0;
    ray_0.from_record_0 = enter_0;
    ray_0.from_camera_0 = camera_number_0(u32(34)) * size_1 + enter_0;
    return ray_0;
}

fn changing_0( value_0 : vec3<f32>,  change_0 : vec3<f32>) -> vec3<f32>
{
    return value_0;
}

fn still_0( value_1 : vec3<f32>) -> vec3<f32>
{
    return changing_0(value_1, vec3<f32>(0.0f));
}

fn change_word_0( at_8 : u32) -> u32
{
    return input_0[launch_0.room_0 + at_8];
}

fn change_vector_0( at_9 : u32) -> vec3<f32>
{
    return (bitcast<vec3<f32>>((vec3<u32>(change_word_0(at_9), change_word_0(at_9 + u32(1)), change_word_0(at_9 + u32(2))))));
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
     enter_1 : f32,
     edge_on_0 : f32,
     largest_0 : f32,
};

fn ray_along_0( origin_1 : vec3<f32>,  direction_1 : vec3<f32>,  t_min_1 : f32,  t_max_1 : f32,  axes_0 : ptr<function, u32>) -> Ray_0
{
    var size_2 : vec3<f32> = abs(direction_1);
    var _S155 : f32 = size_2.x;
    var _S156 : f32 = size_2.y;
    var _S157 : bool;
    if(_S155 >= _S156)
    {
        _S157 = _S155 >= (size_2.z);
    }
    else
    {
        _S157 = false;
    }
    var _S158 : i32;
    if(_S157)
    {
        _S158 = i32(0);
    }
    else
    {
        if(_S156 >= (size_2.z))
        {
            _S158 = i32(1);
        }
        else
        {
            _S158 = i32(2);
        }
    }
    var z_3 : u32 = u32(_S158);
    var x_12 : u32 = (z_3 + u32(1)) % u32(3);
    var y_4 : u32 = (z_3 + u32(2)) % u32(3);
    (*axes_0) = (((x_12 | (((y_4 << (u32(2))))))) | (((z_3 << (u32(4))))));
    var ray_1 : Ray_0;
    ray_1.origin_0 = origin_1;
    var along_0 : f32 = component_0(direction_1, z_3);
    ray_1.inverse_z_0 = 1.0f / along_0;
    ray_1.shear_x_0 = component_0(direction_1, x_12) / along_0;
    ray_1.shear_y_0 = component_0(direction_1, y_4) / along_0;
    ray_1.t_min_0 = t_min_1;
    ray_1.t_max_0 = t_max_1;
    ray_1.local_per_t_0 = abs(along_0);
    ray_1.enter_1 = 0.0f;
    ray_1.edge_on_0 = limit_at_0(u32(0));
    ray_1.largest_0 = limit_at_0(u32(1));
    return ray_1;
}

fn ray_child_0( node_0 : u32,  slot_0 : u32) -> u32
{
    return nodes_0[u32(14) * node_0 + u32(12) + slot_0 / u32(4)][slot_0 % u32(4)];
}

struct RayView_0
{
     inverse_0 : vec3<f32>,
     offset_near_0 : vec3<f32>,
     offset_far_0 : vec3<f32>,
     limit_0 : f32,
     margin_0 : f32,
     axes_1 : u32,
};

fn ray_bound_0( view_0 : RayView_0,  limit_1 : f32,  node_1 : u32,  slot_1 : u32) -> f32
{
    var _S159 : u32 = u32(14) * node_1 + slot_1 / u32(4);
    var near_0 : f32 = 0.0f;
    var far_0 : f32 = limit_1;
    var axis_2 : u32 = u32(0);
    for(;;)
    {
        if(axis_2 < u32(3))
        {
        }
        else
        {
            break;
        }
        var _S160 : u32 = axis_2;
        var _S161 : u32 = _S159 + u32(2) * axis_2;
        var _S162 : u32 = slot_1 % u32(4);
        var low_3 : f32 = (bitcast<f32>((nodes_0[_S161][_S162])));
        var high_0 : f32 = (bitcast<f32>((nodes_0[_S161 + u32(6)][_S162])));
        var _S163 : bool = (view_0.inverse_0[axis_2]) < 0.0f;
        var _S164 : f32;
        if(_S163)
        {
            _S164 = high_0;
        }
        else
        {
            _S164 = low_3;
        }
        var _S165 : f32 = max(near_0, _S164 * view_0.inverse_0[_S160] - view_0.offset_near_0[axis_2]);
        var _S166 : f32;
        if(_S163)
        {
            _S166 = low_3;
        }
        else
        {
            _S166 = high_0;
        }
        var _S167 : f32 = min(far_0, _S166 * view_0.inverse_0[_S160] - view_0.offset_far_0[axis_2]);
        var _S168 : u32 = axis_2 + u32(1);
        near_0 = _S165;
        far_0 = _S167;
        axis_2 = _S168;
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
    var k_0 : u32 = u32(0);
    var order_0 : u32 = u32(0);
    for(;;)
    {
        if(k_0 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S169 : u32 = k_0;
        if((bounds_0[k_0]) > limit_2)
        {
            k_0 = k_0 + u32(1);
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
            var _S170 : u32 = j_0;
            var _S171 : bool;
            if((bounds_0[j_0]) < (bounds_0[_S169]))
            {
                _S171 = true;
            }
            else
            {
                if((bounds_0[_S170]) == (bounds_0[_S169]))
                {
                    _S171 = j_0 < k_0;
                }
                else
                {
                    _S171 = false;
                }
            }
            if(_S171)
            {
                rank_0 = rank_0 + u32(1);
            }
            j_0 = j_0 + u32(1);
        }
        order_0 = (order_0 | ((((k_0 + u32(1)) << ((u32(4) * rank_0))))));
        k_0 = k_0 + u32(1);
    }
    return order_0;
}

fn crossed_0( view_1 : RayView_0,  limit_3 : f32,  node_2 : u32) -> u32
{
    var bounds_1 : array<f32, i32(8)>;
    var slot_2 : u32 = u32(0);
    for(;;)
    {
        if(slot_2 < u32(8))
        {
        }
        else
        {
            break;
        }
        var _S172 : f32;
        if((ray_child_0(node_2, slot_2)) == u32(4294967295))
        {
            _S172 = 3.00000000549775576e+38f;
        }
        else
        {
            _S172 = ray_bound_0(view_1, limit_3, node_2, slot_2);
        }
        bounds_1[slot_2] = _S172;
        slot_2 = slot_2 + u32(1);
    }
    return nearest_first_0(bounds_1, limit_3);
}

fn rounded_0( product_1 : f32,  largest_1 : f32) -> f32
{
    return min(product_1, largest_1);
}

fn corner_0( ray_2 : Ray_0,  axes_2 : u32,  at_10 : u32) -> vec3<f32>
{
    var relative_0 : vec3<f32> = primitive_vector_0(at_10) - ray_2.origin_0;
    var z_4 : f32 = component_0(relative_0, (axes_2 >> (u32(4))));
    return vec3<f32>(component_0(relative_0, (axes_2 & (u32(3)))) - rounded_0(ray_2.shear_x_0 * z_4, ray_2.largest_0), component_0(relative_0, (((axes_2 >> (u32(2)))) & (u32(3)))) - rounded_0(ray_2.shear_y_0 * z_4, ray_2.largest_0), z_4);
}

struct Crossing_0
{
     is_hit_0 : bool,
     t_2 : f32,
     v_1 : f32,
     w_0 : f32,
};

fn intersect_0( ray_3 : Ray_0,  axes_3 : u32,  at_11 : u32) -> Crossing_0
{
    var crossing_0 : Crossing_0;
    crossing_0.is_hit_0 = false;
    crossing_0.t_2 = 0.0f;
    crossing_0.v_1 = 0.0f;
    crossing_0.w_0 = 0.0f;
    var a_3 : vec3<f32> = corner_0(ray_3, axes_3, at_11);
    var b_3 : vec3<f32> = corner_0(ray_3, axes_3, at_11 + u32(3));
    var c_0 : vec3<f32> = corner_0(ray_3, axes_3, at_11 + u32(6));
    var _S173 : f32 = c_0.x;
    var _S174 : f32 = b_3.y;
    var cx_by_0 : f32 = rounded_0(_S173 * _S174, ray_3.largest_0);
    var _S175 : f32 = c_0.y;
    var _S176 : f32 = b_3.x;
    var cy_bx_0 : f32 = rounded_0(_S175 * _S176, ray_3.largest_0);
    var _S177 : f32 = a_3.x;
    var ax_cy_0 : f32 = rounded_0(_S177 * _S175, ray_3.largest_0);
    var _S178 : f32 = a_3.y;
    var ay_cx_0 : f32 = rounded_0(_S178 * _S173, ray_3.largest_0);
    var bx_ay_0 : f32 = rounded_0(_S176 * _S178, ray_3.largest_0);
    var by_ax_0 : f32 = rounded_0(_S174 * _S177, ray_3.largest_0);
    var u_1 : f32 = cx_by_0 - cy_bx_0;
    var v_2 : f32 = ax_cy_0 - ay_cx_0;
    var w_1 : f32 = bx_ay_0 - by_ax_0;
    var _S179 : f32 = min(min(u_1, v_2), w_1);
    var _S180 : f32 = max(max(u_1, v_2), w_1);
    var _S181 : bool;
    if(_S179 < 0.0f)
    {
        _S181 = _S180 > 0.0f;
    }
    else
    {
        _S181 = false;
    }
    if(_S181)
    {
        return crossing_0;
    }
    var determinant_0 : f32 = u_1 + v_2 + w_1;
    if(_S179 <= 0.0f)
    {
        _S181 = _S180 >= 0.0f;
    }
    else
    {
        _S181 = false;
    }
    if(_S181)
    {
        if((abs(determinant_0)) <= (ray_3.edge_on_0 * (abs(cx_by_0) + abs(cy_bx_0) + abs(ax_cy_0) + abs(ay_cx_0) + abs(bx_ay_0) + abs(by_ax_0))))
        {
            return crossing_0;
        }
    }
    if(determinant_0 == 0.0f)
    {
        return crossing_0;
    }
    var t_3 : f32 = (rounded_0(u_1 * a_3.z, ray_3.largest_0) + rounded_0(v_2 * b_3.z, ray_3.largest_0) + rounded_0(w_1 * c_0.z, ray_3.largest_0)) / determinant_0 * ray_3.inverse_z_0;
    if((ray_3.t_min_0) <= t_3)
    {
        _S181 = t_3 <= (ray_3.t_max_0);
    }
    else
    {
        _S181 = false;
    }
    crossing_0.is_hit_0 = _S181;
    crossing_0.t_2 = t_3;
    crossing_0.v_1 = v_2 / determinant_0;
    crossing_0.w_0 = w_1 / determinant_0;
    return crossing_0;
}

fn face_0( triangle_0 : u32) -> u32
{
    return rough_0[triangle_0 / u32(4)][triangle_0 % u32(4)];
}

struct Found_0
{
     face_1 : u32,
     triangle_1 : u32,
     v_3 : f32,
     w_2 : f32,
};

fn first_found_0( view_2 : RayView_0,  ray_4 : ptr<function, Ray_0>,  any_0 : bool) -> Found_0
{
    var _S182 : bool;
    var found_0 : Found_0;
    found_0.face_1 = u32(4294967295);
    found_0.triangle_1 = u32(4294967295);
    found_0.v_3 = 0.0f;
    found_0.w_2 = 0.0f;
    if(!((view_2.limit_0) >= 0.0f))
    {
        return found_0;
    }
    var way_0 : array<vec2<u32>, i32(40)>;
    way_0[i32(0)] = vec2<u32>(u32(0), u32(0));
    var entered_0 : u32 = u32(0);
    var limit_4 : f32 = view_2.limit_0;
    var is_new_0 : bool = true;
    var level_0 : u32 = u32(0);
    for(;;)
    {
        var entered_1 : u32;
        var is_new_1 : bool;
        if(entered_0 != u32(4294967295))
        {
            way_0[level_0] = vec2<u32>(entered_0, crossed_0(view_2, limit_4, entered_0));
            is_new_1 = true;
            entered_1 = u32(4294967295);
        }
        else
        {
            is_new_1 = is_new_0;
            entered_1 = entered_0;
        }
        var here_0 : vec2<u32> = way_0[level_0];
        var _S183 : u32 = way_0[level_0].y;
        if(_S183 == u32(0))
        {
            if(level_0 == u32(0))
            {
                break;
            }
            var _S184 : u32 = level_0 - u32(1);
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            level_0 = _S184;
            continue;
        }
        var slot_3 : u32 = ((_S183 & (u32(15)))) - u32(1);
        way_0[level_0][i32(1)] = (_S183 >> (u32(4)));
        var _S185 : bool;
        if(!is_new_1)
        {
            _S185 = (ray_bound_0(view_2, limit_4, here_0.x, slot_3)) > limit_4;
        }
        else
        {
            _S185 = false;
        }
        if(_S185)
        {
            entered_0 = entered_1;
            is_new_0 = is_new_1;
            continue;
        }
        var child_0 : u32 = ray_child_0(here_0.x, slot_3);
        if(((child_0 & (u32(2147483648)))) == u32(0))
        {
            var _S186 : u32 = level_0 + u32(1);
            entered_0 = child_0;
            is_new_0 = false;
            level_0 = _S186;
            continue;
        }
        var leaf_0 : u32 = (child_0 & (u32(2147483647)));
        var _S187 : u32 = leaf_starts_0[leaf_0 + u32(1)];
        var _S188 : u32 = leaf_starts_0[leaf_0];
        var limit_5 : f32 = limit_4;
        var i_0 : u32 = _S188;
        for(;;)
        {
            if(i_0 < _S187)
            {
            }
            else
            {
                break;
            }
            var crossing_1 : Crossing_0 = intersect_0((*ray_4), view_2.axes_1, u32(9) * i_0);
            if(!crossing_1.is_hit_0)
            {
                i_0 = i_0 + u32(1);
                continue;
            }
            if((found_0.face_1) == u32(4294967295))
            {
                _S182 = true;
            }
            else
            {
                _S182 = (crossing_1.t_2) < ((*ray_4).t_max_0);
            }
            var _S189 : bool;
            if(_S182)
            {
                _S189 = true;
            }
            else
            {
                _S189 = (face_0(i_0)) < (found_0.face_1);
            }
            var limit_6 : f32;
            if(_S189)
            {
                found_0.face_1 = face_0(i_0);
                found_0.triangle_1 = i_0;
                (*ray_4).t_max_0 = crossing_1.t_2;
                found_0.v_3 = crossing_1.v_1;
                found_0.w_2 = crossing_1.w_0;
                limit_6 = min(limit_5, crossing_1.t_2 * (*ray_4).local_per_t_0 - (*ray_4).enter_1 + 2.0f * view_2.margin_0);
            }
            else
            {
                limit_6 = limit_5;
            }
            limit_5 = limit_6;
            i_0 = i_0 + u32(1);
        }
        if(any_0)
        {
            _S182 = (found_0.face_1) != u32(4294967295);
        }
        else
        {
            _S182 = false;
        }
        if(_S182)
        {
            break;
        }
        entered_0 = entered_1;
        limit_4 = limit_5;
        is_new_0 = false;
    }
    return found_0;
}

fn cast_0( origin_2 : vec3<f32>,  direction_2 : vec3<f32>,  t_min_2 : f32,  t_max_2 : f32,  any_1 : bool,  t_4 : ptr<function, f32>) -> Found_0
{
    var view_3 : RayView_0;
    var _S190 : u32 = view_3.axes_1;
    var _S191 : Ray_0 = ray_along_0(origin_2, direction_2, t_min_2, t_max_2, &(_S190));
    view_3.axes_1 = _S190;
    var ray_5 : Ray_0 = _S191;
    var _S192 : vec3<f32> = direction_2 / vec3<f32>(ray_5.local_per_t_0);
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
        var _S193 : f32 = max(abs(_S192[axis_3]), 8.67361737988403547e-19f);
        var _S194 : f32;
        if((_S192[axis_3]) < 0.0f)
        {
            _S194 = -1.0f / _S193;
        }
        else
        {
            _S194 = 1.0f / _S193;
        }
        view_3.inverse_0[axis_3] = _S194;
        axis_3 = axis_3 + u32(1);
    }
    var offset_0 : vec3<f32> = origin_2 * view_3.inverse_0;
    var wider_0 : vec3<f32> = vec3<f32>(3.814697265625e-06f) * abs(view_3.inverse_0);
    view_3.offset_near_0 = offset_0 + wider_0;
    view_3.offset_far_0 = offset_0 - wider_0;
    view_3.limit_0 = min(t_max_2 * ray_5.local_per_t_0, 8.0f) + 3.814697265625e-06f;
    view_3.margin_0 = 3.814697265625e-06f;
    var found_1 : Found_0 = first_found_0(view_3, &(ray_5), any_1);
    (*t_4) = ray_5.t_max_0;
    return found_1;
}

struct Place_0
{
     triangle_2 : u32,
     v_4 : f32,
     w_3 : f32,
     v_rest_0 : f32,
     w_rest_0 : f32,
};

fn exact_place_0( triangle_3 : u32,  v_5 : f32,  w_4 : f32) -> Place_0
{
    var place_1 : Place_0;
    place_1.triangle_2 = triangle_3;
    place_1.v_4 = v_5;
    place_1.w_3 = w_4;
    place_1.v_rest_0 = 0.0f;
    place_1.w_rest_0 = 0.0f;
    return place_1;
}

fn place_of_0( found_2 : Found_0) -> Place_0
{
    return exact_place_0(found_2.triangle_1, found_2.v_3, found_2.w_2);
}

fn triangle_record_0( triangle_4 : u32) -> u32
{
    return word_0(u32(9)) + u32(5) * triangle_4;
}

fn shape_of_0( triangle_5 : u32) -> u32
{
    return word_0(u32(10)) + u32(7) * word_0(triangle_record_0(triangle_5));
}

fn cross_of_0( triangle_6 : u32) -> vec3<f32>
{
    var at_12 : u32 = u32(9) * triangle_6;
    var a_4 : vec3<f32> = primitive_vector_0(at_12);
    return cross(primitive_vector_0(at_12 + u32(3)) - a_4, primitive_vector_0(at_12 + u32(6)) - a_4);
}

fn emitter_seen_0( found_3 : Found_0,  direction_3 : vec3<f32>) -> u32
{
    if((found_3.face_1) == u32(4294967295))
    {
        return word_0(u32(8));
    }
    var emitter_0 : u32 = word_0(shape_of_0(found_3.triangle_1) + u32(4));
    var _S195 : bool;
    if(emitter_0 != u32(4294967295))
    {
        _S195 = (dot(cross_of_0(found_3.triangle_1), direction_3)) < 0.0f;
    }
    else
    {
        _S195 = false;
    }
    var _S196 : u32;
    if(_S195)
    {
        _S196 = emitter_0;
    }
    else
    {
        _S196 = u32(4294967295);
    }
    return _S196;
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
     by_first_0 : vec4<f32>,
     by_second_0 : vec4<f32>,
};

fn one_texel_0( texel_0 : u32) -> Lookup_0
{
    var lookup_0 : Lookup_0;
    lookup_0.count_0 = u32(1);
    lookup_0.texels_0 = vec4<u32>(texel_0, u32(0), u32(0), u32(0));
    lookup_0.weights_0 = vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f);
    var _S197 : vec4<f32> = vec4<f32>(0.0f);
    lookup_0.by_second_0 = _S197;
    lookup_0.by_first_0 = _S197;
    return lookup_0;
}

struct Corners2_0
{
     a_5 : vec2<f32>,
     b_4 : vec2<f32>,
     c_1 : vec2<f32>,
};

fn Corners2_x24init_0( a_6 : vec2<f32>,  b_5 : vec2<f32>,  c_2 : vec2<f32>) -> Corners2_0
{
    var _S198 : Corners2_0;
    _S198.a_5 = a_6;
    _S198.b_4 = b_5;
    _S198.c_1 = c_2;
    return _S198;
}

fn precise_0( at_13 : u32) -> f32
{
    return number_0(at_13) + number_0(at_13 + u32(1));
}

fn uvs_of_0( triangle_7 : u32) -> Corners2_0
{
    var uvs_0 : Corners2_0 = Corners2_x24init_0(vec2<f32>(0.0f, 0.0f), vec2<f32>(1.0f, 0.0f), vec2<f32>(0.0f, 1.0f));
    var uvs_at_0 : u32 = word_0(shape_of_0(triangle_7) + u32(1));
    if(uvs_at_0 == u32(4294967295))
    {
        return uvs_0;
    }
    var at_14 : u32 = uvs_at_0 + u32(12) * word_0(triangle_record_0(triangle_7) + u32(1));
    uvs_0.a_5 = vec2<f32>(precise_0(at_14), precise_0(at_14 + u32(2)));
    uvs_0.b_4 = vec2<f32>(precise_0(at_14 + u32(4)), precise_0(at_14 + u32(6)));
    uvs_0.c_1 = vec2<f32>(precise_0(at_14 + u32(8)), precise_0(at_14 + u32(10)));
    return uvs_0;
}

fn row_at_0( at_15 : u32) -> vec3<f32>
{
    return vec3<f32>(precise_0(at_15), precise_0(at_15 + u32(2)), precise_0(at_15 + u32(4)));
}

fn floor_of_0( x_13 : f32) -> i32
{
    return i32(clamp(floor(x_13), -1.0e+09f, 1.0e+09f));
}

fn wrapped_0( i_1 : i32,  n_0 : i32,  wrap_0 : u32) -> u32
{
    if(wrap_0 == u32(2))
    {
        return u32(clamp(i_1, i32(0), n_0 - i32(1)));
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
    var inside_0 : i32 = i_1 % period_0;
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
     value_2 : vec2<f32>,
     by_first_1 : vec2<f32>,
     by_second_1 : vec2<f32>,
};

fn between_0( texels_1 : vec4<u32>,  place_2 : Point_0) -> Lookup_0
{
    var way_1 : vec2<f32> = place_2.value_2 - floor(place_2.value_2);
    var back_0 : vec2<f32> = vec2<f32>(1.0f) - way_1;
    var lookup_1 : Lookup_0;
    lookup_1.count_0 = u32(4);
    lookup_1.texels_0 = texels_1;
    var _S199 : f32 = back_0.x;
    var _S200 : f32 = back_0.y;
    var _S201 : f32 = way_1.x;
    var _S202 : f32 = way_1.y;
    lookup_1.weights_0 = vec4<f32>(_S199 * _S200, _S201 * _S200, _S199 * _S202, _S201 * _S202);
    var by_x_0 : vec4<f32> = vec4<f32>(- _S200, _S200, - _S202, _S202);
    var by_y_0 : vec4<f32> = vec4<f32>(- _S199, - _S201, _S199, _S201);
    lookup_1.by_first_0 = by_x_0 * vec4<f32>(place_2.by_first_1.x) + by_y_0 * vec4<f32>(place_2.by_first_1.y);
    lookup_1.by_second_0 = by_x_0 * vec4<f32>(place_2.by_second_1.x) + by_y_0 * vec4<f32>(place_2.by_second_1.y);
    return lookup_1;
}

fn in_bitmap_0( texture_0 : u32,  uv_0 : Point_0) -> Lookup_0
{
    var width_2 : i32 = i32(word_0(texture_0 + u32(2)));
    var height_0 : i32 = i32(word_0(texture_0 + u32(3)));
    var wrap_1 : u32 = word_0(texture_0 + u32(5));
    var size_3 : vec2<f32> = vec2<f32>(f32(width_2), f32(height_0));
    var place_3 : vec2<f32> = uv_0.value_2 * size_3;
    if((word_0(texture_0 + u32(4))) == u32(0))
    {
        var row_1 : u32 = wrapped_0(floor_of_0(place_3.y), height_0, wrap_1);
        var _S203 : u32 = row_1 * u32(width_2);
        var _S204 : u32 = wrapped_0(floor_of_0(place_3.x), width_2, wrap_1);
        return one_texel_0(_S203 + _S204);
    }
    var centred_0 : Point_0;
    var _S205 : vec2<f32> = place_3 - vec2<f32>(0.5f);
    centred_0.value_2 = _S205;
    centred_0.by_first_1 = uv_0.by_first_1 * size_3;
    centred_0.by_second_1 = uv_0.by_second_1 * size_3;
    var x_14 : i32 = floor_of_0(_S205.x);
    var y_5 : i32 = floor_of_0(_S205.y);
    var _S206 : u32 = wrapped_0(y_5, height_0, wrap_1);
    var _S207 : u32 = u32(width_2);
    var first_2 : u32 = _S206 * _S207;
    var _S208 : u32 = wrapped_0(y_5 + i32(1), height_0, wrap_1);
    var second_1 : u32 = _S208 * _S207;
    var left_0 : u32 = wrapped_0(x_14, width_2, wrap_1);
    var right_0 : u32 = wrapped_0(x_14 + i32(1), width_2, wrap_1);
    return between_0(vec4<u32>(first_2 + left_0, first_2 + right_0, second_1 + left_0, second_1 + right_0), centred_0);
}

fn lookup_at_0( texture_1 : u32,  place_4 : Place_0) -> Lookup_0
{
    var kind_1 : u32 = word_0(texture_1);
    if(kind_1 == u32(0))
    {
        return one_texel_0(u32(0));
    }
    var record_1 : u32 = triangle_record_0(place_4.triangle_2) + u32(1);
    if(kind_1 == u32(4))
    {
        return one_texel_0(word_0(record_1));
    }
    if(kind_1 == u32(3))
    {
        var lookup_2 : Lookup_0;
        lookup_2.count_0 = u32(3);
        lookup_2.texels_0 = vec4<u32>(word_0(record_1 + u32(1)), word_0(record_1 + u32(2)), word_0(record_1 + u32(3)), u32(0));
        lookup_2.weights_0 = vec4<f32>(1.0f - place_4.v_4 - place_4.w_3, place_4.v_4, place_4.w_3, 0.0f);
        lookup_2.by_first_0 = vec4<f32>(-1.0f, 1.0f, 0.0f, 0.0f);
        lookup_2.by_second_0 = vec4<f32>(-1.0f, 0.0f, 1.0f, 0.0f);
        return lookup_2;
    }
    var uvs_1 : Corners2_0 = uvs_of_0(place_4.triangle_2);
    var by_v_0 : vec2<f32> = uvs_1.b_4 - uvs_1.a_5;
    var by_w_0 : vec2<f32> = uvs_1.c_1 - uvs_1.a_5;
    var _S209 : u32 = texture_1 + u32(6);
    var to_u_0 : vec3<f32> = row_at_0(_S209);
    var to_v_0 : vec3<f32> = row_at_0(_S209 + u32(6));
    var uv_1 : Point_0;
    var _S210 : vec3<f32> = vec3<f32>(uvs_1.a_5 + by_v_0 * vec2<f32>((place_4.v_4 + place_4.v_rest_0)) + by_w_0 * vec2<f32>((place_4.w_3 + place_4.w_rest_0)), 1.0f);
    uv_1.value_2 = vec2<f32>(dot(_S210, to_u_0), dot(_S210, to_v_0));
    var _S211 : vec2<f32> = to_u_0.xy;
    var _S212 : vec2<f32> = to_v_0.xy;
    uv_1.by_first_1 = vec2<f32>(dot(by_v_0, _S211), dot(by_v_0, _S212));
    uv_1.by_second_1 = vec2<f32>(dot(by_w_0, _S211), dot(by_w_0, _S212));
    if(kind_1 == u32(1))
    {
        var _S213 : Lookup_0 = in_bitmap_0(texture_1, uv_1);
        return _S213;
    }
    var half_of_period_0 : vec2<f32> = uv_1.value_2 - floor(uv_1.value_2);
    var _S214 : i32;
    if(((half_of_period_0.x) > 0.5f) != ((half_of_period_0.y) > 0.5f))
    {
        _S214 = i32(1);
    }
    else
    {
        _S214 = i32(0);
    }
    return one_texel_0(u32(_S214));
}

fn weighted_texels_0( texture_2 : u32,  lookup_3 : Lookup_0,  weights_1 : vec4<f32>) -> vec3<f32>
{
    var _S215 : u32 = word_0(texture_2 + u32(1));
    var _S216 : u32 = texture_2 + u32(19);
    var _S217 : vec3<f32> = vec3<f32>(0.0f);
    var k_1 : u32 = u32(0);
    var value_3 : vec3<f32> = _S217;
    for(;;)
    {
        if(k_1 < (lookup_3.count_0))
        {
        }
        else
        {
            break;
        }
        var at_16 : u32 = _S216 + _S215 * lookup_3.texels_0[k_1];
        var _S218 : vec3<f32>;
        if(_S215 == u32(1))
        {
            _S218 = vec3<f32>(number_0(at_16));
        }
        else
        {
            _S218 = vector_at_0(at_16);
        }
        var value_4 : vec3<f32> = value_3 + _S218 * vec3<f32>(weights_1[k_1]);
        k_1 = k_1 + u32(1);
        value_3 = value_4;
    }
    return value_3;
}

fn looked_up_0( texture_3 : u32,  lookup_4 : Lookup_0,  place_change_0 : vec2<f32>) -> vec3<f32>
{
    return weighted_texels_0(texture_3, lookup_4, lookup_4.weights_0);
}

fn shown_0( texture_4 : u32,  place_5 : Place_0) -> vec3<f32>
{
    var _S219 : Lookup_0 = lookup_at_0(texture_4, place_5);
    return looked_up_0(texture_4, _S219, vec2<f32>(0.0f));
}

fn value_of_0( vector_0 : vec3<f32>) -> vec3<f32>
{
    return vector_0;
}

fn angle_of_0( x_15 : f32,  y_6 : f32) -> f32
{
    var _S220 : f32 = abs(x_15);
    var _S221 : f32 = abs(y_6);
    var _S222 : f32 = min(_S220, _S221);
    var _S223 : f32 = max(_S220, _S221);
    var is_steep_2 : bool = _S222 > (0.41421356797218323f * _S223);
    var above_2 : f32;
    if(is_steep_2)
    {
        above_2 = _S222 - _S223;
    }
    else
    {
        above_2 = _S222;
    }
    var below_2 : f32;
    if(is_steep_2)
    {
        below_2 = _S222 + _S223;
    }
    else
    {
        below_2 = _S223;
    }
    if(below_2 > 0.0f)
    {
    }
    else
    {
        below_2 = 1.0f;
    }
    var t_5 : f32 = above_2 / below_2;
    var z_5 : f32 = t_5 * t_5;
    var angle_3 : f32 = (((0.08053744584321976f * z_5 - 0.13877685368061066f) * z_5 + 0.19977711141109467f) * z_5 - 0.33332949876785278f) * z_5 * t_5 + t_5;
    var angle_4 : f32;
    if(is_steep_2)
    {
        angle_4 = angle_3 + 0.78539818525314331f;
    }
    else
    {
        angle_4 = angle_3;
    }
    if(_S221 > _S220)
    {
        angle_4 = 1.57079637050628662f - angle_4;
    }
    if(x_15 < 0.0f)
    {
        angle_4 = 3.14159274101257324f - angle_4;
    }
    if(y_6 < 0.0f)
    {
        above_2 = - angle_4;
    }
    else
    {
        above_2 = angle_4;
    }
    return above_2;
}

fn map_place_0( map_1 : u32,  direction_4 : vec3<f32>) -> vec2<f32>
{
    var _S224 : u32 = map_1 + u32(2);
    var d_2 : vec3<f32> = vector_at_0(_S224) * vec3<f32>(direction_4.x) + vector_at_0(_S224 + u32(3)) * vec3<f32>(direction_4.y) + vector_at_0(_S224 + u32(6)) * vec3<f32>(direction_4.z);
    return vec2<f32>(angle_of_0(- d_2.z, d_2.x) * 0.15915493667125702f * f32(word_0(map_1)) - 0.5f, angle_of_0(d_2.y, length(d_2.xz)) * 0.31830987334251404f * (f32(word_0(map_1 + u32(1))) - 1.0f));
}

fn in_map_0( map_2 : u32,  direction_5 : vec3<f32>) -> Lookup_0
{
    var place_6 : vec2<f32> = map_place_0(map_2, direction_5);
    var point_0 : Point_0;
    point_0.value_2 = place_6;
    point_0.by_first_1 = vec2<f32>(1.0f, 0.0f);
    point_0.by_second_1 = vec2<f32>(0.0f, 1.0f);
    var x_16 : i32 = floor_of_0(place_6.x);
    var y_7 : i32 = floor_of_0(place_6.y);
    var width_3 : i32 = i32(word_0(map_2));
    var height_1 : i32 = i32(word_0(map_2 + u32(1)));
    var left_1 : u32 = wrapped_0(x_16, width_3, u32(0));
    var right_1 : u32 = wrapped_0(x_16 + i32(1), width_3, u32(0));
    var _S225 : u32 = wrapped_0(y_7, height_1, u32(2));
    var _S226 : u32 = u32(width_3);
    var first_3 : u32 = _S225 * _S226;
    var _S227 : u32 = wrapped_0(y_7 + i32(1), height_1, u32(2));
    var second_2 : u32 = _S227 * _S226;
    return between_0(vec4<u32>(first_3 + left_1, first_3 + right_1, second_2 + left_1, second_2 + right_1), point_0);
}

fn emitted_0( emitter_2 : u32,  place_7 : Place_0,  direction_6 : vec3<f32>) -> vec3<f32>
{
    var record_2 : u32 = emitter_record_0(emitter_2);
    var texture_5 : u32 = word_0(record_2 + u32(1));
    if(!is_map_0(record_2))
    {
        var _S228 : vec3<f32> = shown_0(texture_5, place_7);
        return _S228;
    }
    var change_1 : vec2<f32> = vec2<f32>(0.0f);
    var factor_0 : vec3<f32> = looked_up_0(word_0(texture_5 + u32(12)), one_texel_0(u32(0)), change_1);
    var _S229 : u32 = word_0(texture_5 + u32(11));
    var _S230 : Lookup_0 = in_map_0(texture_5, value_of_0(direction_6));
    return looked_up_0(_S229, _S230, change_1) * factor_0;
}

fn numbers_of_0( texture_6 : u32) -> u32
{
    return change_word_0(u32(7) + word_0(texture_6 + u32(18)));
}

fn add_to_sum_0( sum_0 : u32,  derivative_0 : f32)
{
    if(!((abs(derivative_0)) < 3.00000000549775576e+38f))
    {
        var _S231 : u32 = atomicAdd(&(sums_0[u32(1)]), u32(1));
        return;
    }
    var scaled_0 : f32 = derivative_0 * (bitcast<f32>((change_word_0(u32(2)))));
    var size_4 : f32 = abs(scaled_0);
    if(size_4 > 7.73712524553362672e+25f)
    {
        var _S232 : u32 = atomicAdd(&(sums_0[u32(0)]), u32(1));
        return;
    }
    var _S233 : bool = scaled_0 < 0.0f;
    var _S234 : i32;
    if(size_4 >= 1.84467440737095516e+19f)
    {
        _S234 = i32(1);
    }
    else
    {
        _S234 = i32(0);
    }
    var first_4 : u32 = u32(_S234);
    var size_5 : f32;
    if(first_4 == u32(1))
    {
        size_5 = size_4 * 2.32830643653869629e-10f;
    }
    else
    {
        size_5 = size_4;
    }
    var higher_0 : f32 = floor(size_5 * 2.32830643653869629e-10f);
    var lower_0 : f32 = size_5 - higher_0 * 4.294967296e+09f;
    if(first_4 == u32(0))
    {
        size_5 = lower_0 + 0.5f;
    }
    else
    {
        size_5 = lower_0;
    }
    var _S235 : u32 = u32(4) + u32(4) * sum_0;
    var digits_0 : vec2<u32> = vec2<u32>(u32(size_5), u32(higher_0));
    var k_2 : u32 = first_4;
    for(;;)
    {
        var _S236 : bool;
        if(k_2 < u32(4))
        {
            _S236 = (((digits_0.x) | ((digits_0.y)))) != u32(0);
        }
        else
        {
            _S236 = false;
        }
        if(_S236)
        {
        }
        else
        {
            break;
        }
        var _S237 : u32;
        if(_S233)
        {
            _S237 = u32(0) - digits_0.x;
        }
        else
        {
            _S237 = digits_0.x;
        }
        var before_0 : u32 = atomicAdd(&(sums_0[_S235 + k_2]), _S237);
        var overflows_0 : bool;
        if(_S233)
        {
            overflows_0 = before_0 < (digits_0.x);
        }
        else
        {
            overflows_0 = (before_0 + digits_0.x) < before_0;
        }
        var _S238 : u32 = digits_0.y;
        if(overflows_0)
        {
            _S234 = i32(1);
        }
        else
        {
            _S234 = i32(0);
        }
        var _S239 : vec2<u32> = vec2<u32>(_S238 + u32(_S234), u32(0));
        var _S240 : u32 = k_2 + u32(1);
        digits_0 = _S239;
        k_2 = _S240;
    }
    return;
}

fn add_to_texels_0( texture_7 : u32,  lookup_5 : Lookup_0,  derivative_1 : vec3<f32>)
{
    var first_5 : u32 = numbers_of_0(texture_7);
    var _S241 : u32 = word_0(texture_7 + u32(1));
    var _S242 : u32;
    if(first_5 == u32(4294967295))
    {
        _S242 = u32(0);
    }
    else
    {
        _S242 = lookup_5.count_0;
    }
    var k_3 : u32 = u32(0);
    for(;;)
    {
        if(k_3 < _S242)
        {
        }
        else
        {
            break;
        }
        var own_0 : vec3<f32> = derivative_1 * vec3<f32>(lookup_5.weights_0[k_3]);
        var own_1 : vec3<f32>;
        if(_S241 == u32(1))
        {
            own_1 = vec3<f32>((own_0.x + own_0.y + own_0.z));
        }
        else
        {
            own_1 = own_0;
        }
        var c_3 : u32 = u32(0);
        for(;;)
        {
            if(c_3 < _S241)
            {
            }
            else
            {
                break;
            }
            add_to_sum_0(first_5 + _S241 * lookup_5.texels_0[k_3] + c_3, own_1[c_3]);
            c_3 = c_3 + u32(1);
        }
        k_3 = k_3 + u32(1);
    }
    return;
}

fn lookup_back_0( texture_8 : u32,  lookup_6 : Lookup_0,  derivative_2 : vec3<f32>) -> vec2<f32>
{
    add_to_texels_0(texture_8, lookup_6, derivative_2);
    return vec2<f32>(dot(weighted_texels_0(texture_8, lookup_6, lookup_6.by_first_0), derivative_2), dot(weighted_texels_0(texture_8, lookup_6, lookup_6.by_second_0), derivative_2));
}

fn is_area_0( record_3 : u32) -> bool
{
    return (word_0(record_3)) == u32(0);
}

fn is_moving_0() -> bool
{
    return (change_word_0(u32(0))) != u32(4294967295);
}

struct AtCorners_0
{
     a_7 : vec3<f32>,
     b_6 : vec3<f32>,
     c_4 : vec3<f32>,
};

fn at_no_corner_0() -> AtCorners_0
{
    var corners_0 : AtCorners_0;
    var _S243 : vec3<f32> = vec3<f32>(0.0f);
    corners_0.c_4 = _S243;
    corners_0.b_6 = _S243;
    corners_0.a_7 = _S243;
    return corners_0;
}

fn add_at_place_0( corners_1 : ptr<function, AtCorners_0>,  place_8 : Place_0,  derivative_3 : vec3<f32>)
{
    (*corners_1).a_7 = (*corners_1).a_7 + derivative_3 * vec3<f32>((1.0f - place_8.v_4 - place_8.w_3));
    (*corners_1).b_6 = (*corners_1).b_6 + derivative_3 * vec3<f32>(place_8.v_4);
    (*corners_1).c_4 = (*corners_1).c_4 + derivative_3 * vec3<f32>(place_8.w_3);
    return;
}

fn place_back_0( points_0 : ptr<function, AtCorners_0>,  place_9 : Place_0,  by_place_0 : vec2<f32>,  by_position_0 : vec3<f32>,  direction_7 : vec3<f32>) -> vec3<f32>
{
    var corner_1 : u32 = u32(9) * place_9.triangle_2;
    var a_8 : vec3<f32> = primitive_vector_0(corner_1);
    var ab_0 : vec3<f32> = primitive_vector_0(corner_1 + u32(3)) - a_8;
    var ac_0 : vec3<f32> = primitive_vector_0(corner_1 + u32(6)) - a_8;
    var across_0 : vec3<f32> = cross(ab_0, ac_0);
    var _S244 : f32 = max(max(abs(across_0.x), abs(across_0.y)), abs(across_0.z));
    var normal_0 : vec3<f32> = across_0 / vec3<f32>(_S244);
    var by_slip_0 : vec3<f32> = by_position_0 + (cross(ac_0, normal_0) * vec3<f32>(by_place_0.x) + cross(normal_0, ab_0) * vec3<f32>(by_place_0.y)) * vec3<f32>((1.0f / (dot(normal_0, normal_0) * _S244)));
    var by_drift_0 : vec3<f32> = by_slip_0 - normal_0 * vec3<f32>((dot(direction_7, by_slip_0) / dot(normal_0, direction_7)));
    add_at_place_0(&((*points_0)), place_9, by_position_0 - by_drift_0);
    return by_drift_0;
}

fn points_of_0( triangle_8 : u32) -> u32
{
    return change_word_0(change_word_0(u32(0)) + u32(2) * word_0(triangle_record_0(triangle_8)));
}

fn add_to_sums_0( first_6 : u32,  derivative_4 : vec3<f32>)
{
    var _S245 : i32;
    if(first_6 == u32(4294967295))
    {
        _S245 = i32(0);
    }
    else
    {
        _S245 = i32(3);
    }
    var _S246 : u32 = u32(_S245);
    var axis_4 : u32 = u32(0);
    for(;;)
    {
        if(axis_4 < _S246)
        {
        }
        else
        {
            break;
        }
        add_to_sum_0(first_6 + axis_4, derivative_4[axis_4]);
        axis_4 = axis_4 + u32(1);
    }
    return;
}

fn add_to_corners_0( sums_at_0 : u32,  triangle_9 : u32,  corners_2 : AtCorners_0)
{
    var _S247 : u32 = triangle_record_0(triangle_9) + u32(2);
    var _S248 : i32;
    if(sums_at_0 == u32(4294967295))
    {
        _S248 = i32(0);
    }
    else
    {
        _S248 = i32(3);
    }
    var _S249 : u32 = u32(_S248);
    var k_4 : u32 = u32(0);
    for(;;)
    {
        if(k_4 < _S249)
        {
        }
        else
        {
            break;
        }
        var _S250 : u32 = sums_at_0 + u32(3) * word_0(_S247 + k_4);
        var _S251 : vec3<f32>;
        if(k_4 == u32(0))
        {
            _S251 = corners_2.a_7;
        }
        else
        {
            if(k_4 == u32(1))
            {
                _S251 = corners_2.b_6;
            }
            else
            {
                _S251 = corners_2.c_4;
            }
        }
        add_to_sums_0(_S250, _S251);
        k_4 = k_4 + u32(1);
    }
    return;
}

fn emitted_back_0( by_start_0 : ptr<function, vec3<f32>>,  emitter_3 : u32,  place_10 : Place_0,  direction_8 : vec3<f32>,  t_6 : f32,  importance_0 : vec3<f32>) -> vec3<f32>
{
    var record_4 : u32 = emitter_record_0(emitter_3);
    var texture_9 : u32 = word_0(record_4 + u32(1));
    var lookup_7 : Lookup_0;
    var by_texels_0 : vec3<f32>;
    if(is_map_0(record_4))
    {
        var scale_0 : u32 = word_0(texture_9 + u32(12));
        var lookup_8 : Lookup_0 = in_map_0(texture_9, direction_8);
        var _S252 : Lookup_0 = one_texel_0(u32(0));
        var by_texels_1 : vec3<f32> = importance_0 * weighted_texels_0(scale_0, _S252, vec4<f32>(1.0f, 0.0f, 0.0f, 0.0f));
        add_to_texels_0(scale_0, _S252, importance_0 * weighted_texels_0(word_0(texture_9 + u32(11)), lookup_8, lookup_8.weights_0));
        lookup_7 = lookup_8;
        by_texels_0 = by_texels_1;
    }
    else
    {
        var _S253 : Lookup_0 = lookup_at_0(texture_9, place_10);
        lookup_7 = _S253;
        by_texels_0 = importance_0;
    }
    var _S254 : u32;
    if(is_map_0(record_4))
    {
        _S254 = word_0(texture_9 + u32(11));
    }
    else
    {
        _S254 = texture_9;
    }
    var by_place_1 : vec2<f32> = lookup_back_0(_S254, lookup_7, by_texels_0);
    if(is_map_0(record_4))
    {
        var _S255 : vec3<f32> = vec3<f32>(0.0f);
        var moving_0 : DiffPair_vectorx3Cfloatx2C3x3E_0;
        moving_0.primal_0 = direction_8;
        moving_0.differential_0 = _S255;
        _S127(texture_9, &(moving_0), by_place_1);
        return moving_0.differential_0;
    }
    var _S256 : bool;
    if(!is_area_0(record_4))
    {
        _S256 = true;
    }
    else
    {
        _S256 = !is_moving_0();
    }
    if(_S256)
    {
        _S256 = true;
    }
    else
    {
        _S256 = (all((by_place_1 == vec2<f32>(0.0f))));
    }
    if(_S256)
    {
        return vec3<f32>(0.0f);
    }
    var points_1 : AtCorners_0 = at_no_corner_0();
    var by_drift_1 : vec3<f32> = place_back_0(&(points_1), place_10, by_place_1, vec3<f32>(0.0f), direction_8);
    add_to_corners_0(points_of_0(place_10.triangle_2), place_10.triangle_2, points_1);
    (*by_start_0) = (*by_start_0) + by_drift_1;
    return by_drift_1 * vec3<f32>(t_6);
}

fn reaches_0( segments_0 : u32) -> bool
{
    return segments_0 <= (word_0(u32(0)));
}

struct ByRay_0
{
     drift_0 : vec3<f32>,
     direction_9 : vec3<f32>,
};

struct Path_0
{
     throughput_0 : vec3<f32>,
     direction_10 : vec3<f32>,
     place_11 : Place_0,
     key_4 : vec2<u32>,
     adjoint_0 : vec3<f32>,
     distance_0 : f32,
     by_ray_0 : ByRay_0,
};

fn begin_0( number_of_path_1 : u32,  path_0 : ptr<function, Path_0>) -> bool
{
    var drawn_3 : CameraSample_0 = camera_sample_0(number_of_path_1);
    var ray_6 : CameraRay_0 = camera_ray_0(drawn_3);
    (*path_0).key_4 = drawn_3.key_3;
    (*path_0).throughput_0 = still_0(vec3<f32>(1.0f));
    (*path_0).adjoint_0 = change_vector_0(change_word_0(u32(5)) + u32(3) * drawn_3.pixel_1) * vec3<f32>(drawn_3.weight_1);
    var _S257 : vec3<f32> = vec3<f32>(0.0f);
    (*path_0).by_ray_0.direction_9 = _S257;
    (*path_0).by_ray_0.drift_0 = _S257;
    var t_7 : f32 = 0.0f;
    var found_4 : Found_0;
    found_4.face_1 = u32(4294967295);
    found_4.triangle_1 = u32(0);
    found_4.v_3 = 0.0f;
    found_4.w_2 = 0.0f;
    var _S258 : bool;
    if((ray_6.length_0) >= 0.0f)
    {
        _S258 = (word_0(u32(14))) != u32(0);
    }
    else
    {
        _S258 = false;
    }
    if(_S258)
    {
        var _S259 : Found_0 = cast_0(ray_6.start_1, ray_6.direction_0, 0.0f, ray_6.length_0, false, &(t_7));
        found_4 = _S259;
    }
    var _S260 : Place_0 = place_of_0(found_4);
    (*path_0).place_11 = _S260;
    (*path_0).direction_10 = ray_6.direction_0;
    var _S261 : f32;
    if((found_4.face_1) != u32(4294967295))
    {
        _S261 = ray_6.from_camera_0 + t_7;
    }
    else
    {
        _S261 = 0.0f;
    }
    (*path_0).distance_0 = _S261;
    var emitter_4 : u32 = emitter_seen_0(found_4, ray_6.direction_0);
    if(emitter_4 != u32(4294967295))
    {
        _S258 = (word_0(u32(4))) != u32(0);
    }
    else
    {
        _S258 = false;
    }
    if(_S258)
    {
        var _S262 : vec3<f32> = emitted_0(emitter_4, _S260, (*path_0).direction_10);
        var _S263 : vec3<f32> = (*path_0).by_ray_0.drift_0;
        var _S264 : vec3<f32> = emitted_back_0(&(_S263), emitter_4, _S260, ray_6.direction_0, (*path_0).distance_0, (*path_0).adjoint_0);
        (*path_0).by_ray_0.drift_0 = _S263;
        (*path_0).by_ray_0.direction_9 = _S264;
    }
    if((found_4.face_1) != u32(4294967295))
    {
        _S258 = reaches_0(u32(2));
    }
    else
    {
        _S258 = false;
    }
    return _S258;
}

fn set_word_0( path_1 : u32,  which_1 : u32,  value_5 : u32)
{
    paths_0[which_1 * launch_0.room_0 + path_1] = value_5;
    return;
}

fn set_vector_0( path_2 : u32,  which_2 : ptr<function, u32>,  value_6 : vec3<f32>)
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
        set_word_0(path_2, (*which_2) + axis_5, (bitcast<u32>((value_6[axis_5]))));
        axis_5 = axis_5 + u32(1);
    }
    (*which_2) = (*which_2) + u32(3);
    return;
}

fn set_vector_1( path_3 : u32,  which_3 : ptr<function, u32>,  value_7 : vec3<f32>)
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
        set_word_0(path_3, (*which_3) + axis_6, (bitcast<u32>((value_7[axis_6]))));
        axis_6 = axis_6 + u32(1);
    }
    (*which_3) = (*which_3) + u32(3);
    return;
}

fn set_vector_2( path_4 : u32,  which_4 : ptr<function, u32>,  value_8 : vec3<f32>)
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
        set_word_0(path_4, (*which_4) + axis_7, (bitcast<u32>((value_8[axis_7]))));
        axis_7 = axis_7 + u32(1);
    }
    (*which_4) = (*which_4) + u32(3);
    return;
}

fn set_changing_0( path_5 : u32,  which_5 : ptr<function, u32>,  vector_1 : vec3<f32>)
{
    set_vector_2(path_5, &((*which_5)), value_of_0(vector_1));
    return;
}

fn set_place_0( path_6 : u32,  which_6 : ptr<function, u32>,  place_12 : Place_0)
{
    set_word_0(path_6, (*which_6), place_12.triangle_2);
    set_word_0(path_6, (*which_6) + u32(1), (bitcast<u32>((place_12.v_4))));
    set_word_0(path_6, (*which_6) + u32(2), (bitcast<u32>((place_12.w_3))));
    set_word_0(path_6, (*which_6) + u32(3), (bitcast<u32>((place_12.v_rest_0))));
    set_word_0(path_6, (*which_6) + u32(4), (bitcast<u32>((place_12.w_rest_0))));
    (*which_6) = (*which_6) + u32(5);
    return;
}

fn store_0( number_of_path_2 : u32,  path_7 : Path_0)
{
    var at_17 : u32 = u32(1);
    set_vector_0(number_of_path_2, &(at_17), path_7.adjoint_0);
    set_changing_0(number_of_path_2, &(at_17), path_7.throughput_0);
    set_changing_0(number_of_path_2, &(at_17), path_7.direction_10);
    set_place_0(number_of_path_2, &(at_17), path_7.place_11);
    var _S265 : u32 = at_17 + u32(1);
    set_word_0(number_of_path_2, at_17, path_7.key_4.x);
    at_17 = _S265 + u32(1);
    set_word_0(number_of_path_2, _S265, path_7.key_4.y);
    return;
}

fn loops_end_0( zero_0 : u32) -> bool
{
    var _S266 : u32;
    var rounds_0 : u32 = u32(0);
    for(;;)
    {
        var _S267 : u32 = u32(2) + zero_0;
        _S266 = _S267;
        if(rounds_0 < _S267)
        {
        }
        else
        {
            break;
        }
        rounds_0 = rounds_0 + u32(1);
    }
    return rounds_0 == _S266;
}

fn check_loops_0()
{
    if(!loops_end_0(((launch_0.room_0) >> (u32(31)))))
    {
        var _S268 : u32 = atomicAdd(&(sums_0[u32(2)]), u32(1));
    }
    return;
}

@compute
@workgroup_size(64, 1, 1)
fn begin_reverse(@builtin(global_invocation_id) thread_0 : vec3<u32>)
{
    var number_of_path_3 : u32 = launch_0.first_0 + thread_0.x;
    if(number_of_path_3 >= (launch_0.end_0))
    {
        return;
    }
    var path_8 : Path_0;
    var goes_on_0 : bool = begin_0(number_of_path_3, &(path_8));
    store_0(number_of_path_3, path_8);
    var which_7 : u32 = u32(17);
    for(;;)
    {
        if(which_7 < u32(26))
        {
        }
        else
        {
            break;
        }
        set_word_0(number_of_path_3, which_7, u32(0));
        which_7 = which_7 + u32(1);
    }
    var camera_ray_1 : u32 = u32(26);
    set_vector_1(number_of_path_3, &(camera_ray_1), path_8.by_ray_0.drift_0);
    set_vector_1(number_of_path_3, &(camera_ray_1), path_8.by_ray_0.direction_9);
    set_word_0(number_of_path_3, camera_ray_1, (bitcast<u32>((path_8.distance_0))));
    if(goes_on_0)
    {
        which_7 = number_of_path_3;
    }
    else
    {
        which_7 = u32(4294967295);
    }
    set_word_0(number_of_path_3, u32(0), which_7);
    check_loops_0();
    return;
}
